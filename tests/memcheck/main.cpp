// Every function of the library on heap blocks of exactly their bytes, with everything uninitialised that is not to be
// read. Valgrind looks on: that nothing else is read, and that all results are made of what was given.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "families.h"
#include "motions.h"
#include "touch.h"

namespace motorway::memcheck {
namespace {

using fuzz::Call;
using fuzz::Function;
using fuzz::Place;
using fuzz::Stream;
using testing::Random;

constexpr std::size_t most = 70;

enum class Layout { packed, with_gaps, arrays };

// A stream in blocks of its own, freed at the end.
class Blocks {
public:
    Blocks(const Stream &stream, Layout layout, std::size_t count) : stream_(stream), count_(count)
    {
        if (stream.kind == Stream::shared)
            count_ = 1;
        const bool arrays = layout == Layout::arrays && stream.kind == Stream::apart;
        const std::size_t gap = layout == Layout::with_gaps && stream.kind != Stream::shared ? 2 * stream.size : 0;
        place_.stride = (arrays ? 1 : stream.components) * stream.size + gap;
        for (std::size_t k = 0; k < stream.components; ++k) {
            if (k == 0 || arrays)
                blocks_.emplace_back(static_cast<char *>(std::malloc(count_ * place_.stride - gap)), std::free);
            place_.component[k] = blocks_.back().get() + (arrays ? 0 : k * stream.size);
        }
    }

    const Place &place() const { return place_; }

    // Of packed elements, only the numbers that are read.
    void write(const char *elements)
    {
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t k = 0; k < stream_.components; ++k)
                if (!(stream_.unread >> k & 1))
                    std::memcpy(place_.component[k] + i * place_.stride,
                                elements + (i * stream_.components + k) * stream_.size, stream_.size);
    }

    void touch() const
    {
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t k = 0; k < stream_.components; ++k)
                memcheck::touch(place_.component[k] + i * place_.stride, stream_.size);
    }

private:
    Stream stream_;
    std::size_t count_;
    Place place_;
    std::vector<std::unique_ptr<char, void (*)(void *)>> blocks_;
};

class Checked {
public:
    Checked(const Function &function, Random &random) : function_(function), random_(random)
    {
        for (const Stream &stream : function.inputs)
            inputs_.emplace_back(most * stream.components * stream.size);
        for (std::size_t i = 0; i < most; ++i) {
            std::vector<void *> element;
            for (std::size_t k = 0; k < inputs_.size(); ++k)
                element.push_back(&inputs_[k][i * inputs_[k].size() / most]);
            function.draw(random, element.data());
        }
    }

    void call(std::size_t way, std::size_t count, Layout layout, bool in_place)
    {
        std::vector<Blocks> in;
        const Blocks out(function_.output, layout, count);
        Call call{out.place(), {}, count, random_};
        std::size_t over = inputs_.size();  // the input that the results take the place of
        for (std::size_t k = 0; k < inputs_.size(); ++k) {
            const Stream &stream = function_.inputs[k], &results = function_.output;
            in.emplace_back(stream, layout, count);
            in[k].write(inputs_[k].data());
            call.in.push_back(in[k].place());
            if (in_place && !function_.apart && stream.kind == results.kind &&
                stream.components == results.components && stream.size == results.size)
                call.out = call.in[over = k];
        }
        const mw_status status = function_.ways[way](call);
        if (status != MW_OK) {
            std::printf("%s: %s\n", function_.name.c_str(), mw_status_text(status));
            std::exit(1);
        }
        over < in.size() ? in[over].touch() : out.touch();
    }

private:
    const Function &function_;
    Random &random_;
    std::vector<std::vector<char>> inputs_;
};

void check(const Function &function, Random &random)
{
    Checked checked(function, random);
    for (std::size_t way = 0; way < function.ways.size(); ++way)
        for (const Layout layout : {Layout::packed, Layout::with_gaps, Layout::arrays}) {
            if (function.apart && layout == Layout::arrays)
                continue;  // between blocks of the results there may be one of an input
            for (const std::size_t count : {1, 3, 17})
                checked.call(way, count, layout, random.chance(3));
            checked.call(way, most, layout, false);
        }
}

}  // namespace
}  // namespace motorway::memcheck

int main()
{
    using namespace motorway;
    if (!mw_isa()) {
        std::printf("skipped: %s\n", mw_status_text(MW_ERROR_ISA));
        return 0;
    }
    testing::Random random(1);
    const fuzz::Functions functions = fuzz::all_functions();
    for (const fuzz::Function &function : functions)
        memcheck::check(function, random);
    memcheck::check_single_motors();
    memcheck::check_motions();
    std::printf("%zu functions of batches, and those of single motors and of motions, on %s\n", functions.size(),
                mw_isa());
    return 0;
}
