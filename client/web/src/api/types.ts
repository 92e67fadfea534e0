// Short names for the wire's types.
import type { components } from "../../generated/schema.d.ts";

type Schemas = components["schemas"];

export type Scene = Schemas["Scene"];
export type Structure = Schemas["Structure"];
export type Kind = Schemas["Kind"];
export type Option = Schemas["Option"];
export type Options = Schemas["Options"];
export type System = Schemas["System"];
export type CameraPose = Schemas["CameraPose"];
export type FrameRequest = Schemas["FrameRequest"];
export type Job = Schemas["Job"];
export type JobRequest = Schemas["JobRequest"];
export type BenchmarkSpec = Schemas["BenchmarkSpec"];
export type BenchmarkResult = Schemas["BenchmarkResult"];
export type AccuracyResult = Schemas["AccuracyResult"];
export type ResultRow = Schemas["ResultRow"];
export type ProblemDocument = Schemas["Problem"];
export type Mode = Schemas["Mode"];
export type Output = NonNullable<FrameRequest["output"]>;
