#include "obj_source.h"

#include <utility>

#include "obj_statements.h"
#include "text.h"

namespace motorway::tool {

ObjSource::ObjSource(SourceText source, Places places) : source_(std::move(source)), places_(std::move(places)) {}

std::string ObjSource::write(const Pose &pose) const
{
    const std::string_view text = source_.text;
    std::string out;
    out.reserve(text.size() + 24 * (places_.positions.size() + places_.normals.size()));
    std::size_t copied = 0, position = 0, normal = 0;
    const auto replace = [&](std::size_t place, const double *vector) {
        ObjPlace at = {place};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::string_view word = obj_word(text, at);
            const auto begin = static_cast<std::size_t>(word.data() - text.data());
            out += text.substr(copied, begin - copied);
            append_number(out, vector[axis]);
            copied = begin + word.size();
        }
    };
    while (position < places_.positions.size() || normal < places_.normals.size()) {
        const bool position_is_next =
            normal == places_.normals.size() ||
            (position < places_.positions.size() && places_.positions[position] < places_.normals[normal]);
        if (position_is_next)
            replace(places_.positions[position], &pose.positions[3 * position]), ++position;
        else
            replace(places_.normals[normal], &pose.normals[3 * normal]), ++normal;
    }
    out += text.substr(copied);
    return with_line_ends(std::move(out), source_.line_end);
}

} // namespace motorway::tool
