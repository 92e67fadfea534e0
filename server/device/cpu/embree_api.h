// The differences between Embree 3 and 4, and nothing else.
#pragma once
#if RAYWALK_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace raywalk::embree {

/// How a query is marked: coherent rays start close together and run alike.
enum class Coherence { coherent, incoherent };

#if RAYWALK_EMBREE_MAJOR == 4

inline RTCRayQueryFlags flags_of(Coherence c) {
  return c == Coherence::coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
}
inline void intersect1(RTCScene scene, RTCRayHit* ray) {
  rtcIntersect1(scene, ray, nullptr);
}
inline void intersect8(const int* valid, RTCScene scene, Coherence c, RTCRayHit8* rays) {
  RTCIntersectArguments args;
  rtcInitIntersectArguments(&args);
  args.flags = flags_of(c);
  rtcIntersect8(valid, scene, rays, &args);
}
inline void occluded8(const int* valid, RTCScene scene, Coherence c, RTCRay8* rays) {
  RTCOccludedArguments args;
  rtcInitOccludedArguments(&args);
  args.flags = flags_of(c);
  rtcOccluded8(valid, scene, rays, &args);
}

#else

inline RTCIntersectContext context_of(Coherence c) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags =
      c == Coherence::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}
inline void intersect1(RTCScene scene, RTCRayHit* ray) {
  RTCIntersectContext context = context_of(Coherence::incoherent);
  rtcIntersect1(scene, &context, ray);
}
inline void intersect8(const int* valid, RTCScene scene, Coherence c, RTCRayHit8* rays) {
  RTCIntersectContext context = context_of(c);
  rtcIntersect8(valid, scene, &context, rays);
}
inline void occluded8(const int* valid, RTCScene scene, Coherence c, RTCRay8* rays) {
  RTCIntersectContext context = context_of(c);
  rtcOccluded8(valid, scene, &context, rays);
}

#endif

}  // namespace raywalk::embree
