// The camera that a link asks for.
import { notice } from "../ui/notice.ts";
import { type Extent, isUsable, type Pose } from "./camera.ts";

/** Null when the link names none, and after a message when it cannot be used. */
export function linkedView(asked: Pose | "bad" | null, extent: Extent, subject: string): Pose | null {
  if (asked === null || (asked !== "bad" && isUsable(asked, extent))) return asked;
  notice(subject, "info", "The camera of this link cannot be used; this is the scene's first view.");
  return null;
}
