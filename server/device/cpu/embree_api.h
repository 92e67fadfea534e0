// The differences between Embree 3 and 4 and between packets of 8 and 16 rays, and nothing else.
#pragma once
#if RAYWALK_EMBREE_MAJOR == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "kernels/platform.h"

namespace raywalk::embree {

/// How a query is marked: coherent rays start close together and run alike.
enum class Coherence { coherent, incoherent };

#if RAYWALK_EMBREE_MAJOR == 4

struct IntersectMark {
  RTCIntersectArguments args;
  explicit IntersectMark(Coherence c) {
    rtcInitIntersectArguments(&args);
    args.flags = c == Coherence::coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
};
struct OccludedMark {
  RTCOccludedArguments args;
  explicit OccludedMark(Coherence c) {
    rtcInitOccludedArguments(&args);
    args.flags = c == Coherence::coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
};
#define RW_EMBREE_CALL(call, ...) call(__VA_ARGS__, &mark.args)
#define RW_EMBREE_VALID_CALL(call, valid, scene, rays) call(valid, scene, rays, &mark.args)

#else

struct IntersectMark {
  RTCIntersectContext context;
  explicit IntersectMark(Coherence c) {
    rtcInitIntersectContext(&context);
    context.flags =
        c == Coherence::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
};
using OccludedMark = IntersectMark;
#define RW_EMBREE_CALL(call, scene, ray) call(scene, &mark.context, ray)
#define RW_EMBREE_VALID_CALL(call, valid, scene, rays) call(valid, scene, &mark.context, rays)

#endif

inline void intersect(RTCScene scene, RTCRayHit* ray) {
  IntersectMark mark(Coherence::incoherent);
  RW_EMBREE_CALL(rtcIntersect1, scene, ray);
}

/// Types and calls of packets of N rays.
template <u32 N>
struct Packet;

#define RW_EMBREE_PACKET(n)                                                               \
  template <>                                                                             \
  struct Packet<n> {                                                                      \
    using Rays = RTCRay##n;                                                               \
    using RayHits = RTCRayHit##n;                                                         \
    static void intersect(const int* valid, RTCScene scene, Coherence c, RayHits* rays) { \
      IntersectMark mark(c);                                                              \
      RW_EMBREE_VALID_CALL(rtcIntersect##n, valid, scene, rays);                          \
    }                                                                                     \
    static void occluded(const int* valid, RTCScene scene, Coherence c, Rays* rays) {     \
      OccludedMark mark(c);                                                               \
      RW_EMBREE_VALID_CALL(rtcOccluded##n, valid, scene, rays);                           \
    }                                                                                     \
  };
RW_EMBREE_PACKET(8)
RW_EMBREE_PACKET(16)
#undef RW_EMBREE_PACKET
#undef RW_EMBREE_CALL
#undef RW_EMBREE_VALID_CALL

}  // namespace raywalk::embree
