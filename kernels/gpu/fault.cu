// A kernel that fails on purpose, for tests of what follows.
extern "C" __global__ void fault() {
  __trap();
}
