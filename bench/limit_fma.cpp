// The rate of fused multiply-adds of one instruction set: compiled with the flags of the kernels of that set, and
// with leave to fuse. Twelve sums are independent of each other: more than latency times units anywhere, and with the
// factor and the term they still fit into sixteen registers.
#include <cstddef>

namespace {

#if defined(MOTORWAY_BENCH_SCALAR)
template <class T> struct vector {
    using type = T;
};
#else
#if defined(__AVX512F__)
#define MOTORWAY_BENCH_WIDTH 64
#elif defined(__AVX__)
#define MOTORWAY_BENCH_WIDTH 32
#else
#define MOTORWAY_BENCH_WIDTH 16
#endif
template <class T> struct vector;
template <> struct vector<float> {
    typedef float type __attribute__((vector_size(MOTORWAY_BENCH_WIDTH)));
};
template <> struct vector<double> {
    typedef double type __attribute__((vector_size(MOTORWAY_BENCH_WIDTH)));
};
#endif

constexpr int sums = 12;

// Makes of a value something that the compiler knows nothing of, in a register.
template <class V> inline V opaque(V value)
{
#if defined(__x86_64__) || defined(__i386__)
    asm volatile("" : "+x"(value));
#elif defined(__aarch64__)
    asm volatile("" : "+w"(value));
#endif
    return value;
}

template <class T> double run(std::size_t rounds)
{
    using V = typename vector<T>::type;
    const V factor = opaque(V{} + T(0.999)), term = opaque(V{} + T(0.001));
    V a{}, b{}, c{}, d{}, e{}, f{}, g{}, h{}, i{}, j{}, k{}, l{}; // an array would live in memory
    const auto step = [&](V &sum) { sum = opaque(sum * factor + term); };
    for (std::size_t round = 0; round < rounds; ++round) {
        step(a), step(b), step(c), step(d), step(e), step(f);
        step(g), step(h), step(i), step(j), step(k), step(l);
    }
    return static_cast<double>(rounds) * sums * (sizeof(V) / sizeof(T));
}

} // namespace

#define MOTORWAY_BENCH_PASTE_(a, b) a##b
#define MOTORWAY_BENCH_PASTE(a, b) MOTORWAY_BENCH_PASTE_(a, b)

namespace motorway::bench {

double MOTORWAY_BENCH_PASTE(run_fma_f32_, MOTORWAY_BENCH_ISA)(std::size_t rounds) { return run<float>(rounds); }
double MOTORWAY_BENCH_PASTE(run_fma_f64_, MOTORWAY_BENCH_ISA)(std::size_t rounds) { return run<double>(rounds); }

} // namespace motorway::bench
