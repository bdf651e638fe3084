#include "round.h"

#include <cmath>
#include <cstdio>

#include "memory.h"

namespace motorway::fuzz {
namespace {

template <class T>
T read(const char *number)
{
    T value;
    std::memcpy(&value, number, sizeof value);
    return value;
}

double number_at(const char *number, std::size_t size)
{
    return size == sizeof(float) ? static_cast<double>(read<float>(number)) : read<double>(number);
}

// The input that the results lie over, or none.
int in_place(const Function &function, testing::Random &random)
{
    std::vector<int> candidates;
    for (std::size_t k = 0; k < function.inputs.size(); ++k)
        if (function.inputs[k].kind != Stream::shared && function.inputs[k].size == function.output.size)
            candidates.push_back(static_cast<int>(k));
    return candidates.empty() || random.chance(2) ? Memory::nowhere : candidates[random.below(candidates.size())];
}

// Elements [begin, begin + count) in some way, against the first results.
Outcome repeat(const Function &function, const Batch &batch, std::size_t begin, std::size_t count,
               testing::Random &random, const Results &results)
{
    std::vector<Stream> streams = function.inputs;
    streams.push_back(function.output);
    const std::size_t last = streams.size() - 1, way = random.below(function.ways.size());
    const bool woven = !function.apart && random.chance(4);
    const int over = function.apart ? Memory::nowhere : in_place(function, random);
    Memory memory(random, streams, count, woven, over);
    for (std::size_t k = 0; k < last; ++k) {
        const std::size_t element = streams[k].components * streams[k].size;
        memory.write(k, batch.inputs[k] + (streams[k].kind == Stream::shared ? 0 : begin * element));
    }
    Call call{memory.place(last), {}, count, random};
    for (std::size_t k = 0; k < last; ++k)
        call.in.push_back(memory.place(k));
    memory.remember();
    const mw_status status = function.ways[way](call);

    Outcome outcome;
    const auto fail = [&](std::size_t i, const char *what) {
        outcome.element = static_cast<std::int64_t>(begin + i);
        std::snprintf(outcome.fault, sizeof outcome.fault, "%s: way %zu, %zu elements from %zu on%s%s, out stride %zu",
                      what, way, count, begin, woven ? ", woven" : "", over < 0 ? "" : ", in place", call.out.stride);
        return outcome;
    };
    if (status != MW_OK)
        return fail(0, mw_status_text(status));
    if (!memory.changed_only(last))
        return fail(0, "bytes were written that are none of the results");
    const std::size_t components = function.output.components, size = function.output.size;
    std::vector<char> elements(count * components * size);
    memory.read(last, elements.data());
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < components; ++c) {
            const std::size_t here = (i * components + c) * size, there = ((begin + i) * components + c) * size;
            if (!same_number(&elements[here], &results.elements[there], size)) {
                char what[80];
                std::snprintf(what, sizeof what, "other bits than alone: component %zu is %a", c,
                              number_at(&elements[here], size));
                return fail(i, what);
            }
        }
    return outcome;
}

}  // namespace

bool same_number(const char *a, const char *b, std::size_t size)
{
    if (std::memcmp(a, b, size) == 0)
        return true;
    return std::isnan(number_at(a, size)) && std::isnan(number_at(b, size));
}

Outcome run(const Function &function, const Batch &batch, std::size_t count, std::uint64_t seed, Results &results)
{
    testing::Random random(seed);
    Call call{packed(function.output, results.elements), {}, count, random};
    for (std::size_t k = 0; k < function.inputs.size(); ++k)
        call.in.push_back(packed(function.inputs[k], const_cast<char *>(batch.inputs[k])));
    std::memset(results.elements, 0xff, count * function.output.components * function.output.size);
    Outcome outcome;
    const mw_status status = function.ways[0](call);
    if (status != MW_OK) {
        std::snprintf(outcome.fault, sizeof outcome.fault, "%s", mw_status_text(status));
        outcome.element = 0;
    }
    for (int repetition = 0; repetition < 4 && outcome.element < 0; ++repetition) {
        const std::size_t begin = random.below(count), most = random.chance(2) ? 4 : count;
        const std::size_t some = 1 + random.below(std::min(count - begin, most));
        outcome = repeat(function, batch, begin, some, random, results);
    }
    return outcome;
}

}  // namespace motorway::fuzz
