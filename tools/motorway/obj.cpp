#include "obj.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "error.h"
#include "obj_source.h"
#include "obj_statements.h"
#include "source_text.h"
#include "text.h"

namespace motorway::tool {
namespace {

/* Statements that a Mesh does not hold, and what they are about. */
struct Beyond {
    std::string_view keywords; /* each between blanks */
    const char *what;
};
constexpr Beyond BEYOND[] = {
    {" usemtl mtllib usemap maplib ", "materials"},
    {" o g s mg ", "groups"},
    {" p ", "points"},
    {" lod bevel c_interp d_interp shadow_obj trace_obj ", "display attributes"},
    {" vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con ctech stech bsp bzp cdc cdp res ",
     "free-form geometry"},
    {" call csh ", "calls of other files"},
};

class ObjReader {
public:
    ObjReader(const std::string &contents, const std::string &path)
        : source_(normalised_text(contents, path)), statements_(source_.text), path_(path)
    {
        mesh_.in_double = true; /* a text has as many digits as it has */
    }

    Mesh read()
    {
        while (statements_.next(words_))
            read_statement(words_[0]);
        check_indices();
        settle_lines();
        settle_numbers(mesh_.corner_normals, mesh_.normal_count());
        settle_numbers(mesh_.corner_uvs, mesh_.uvs.size() / 2);
        settle_colours();
        settle_remarks();
        mesh_.source = std::make_shared<ObjSource>(std::move(source_), std::move(places_));
        return std::move(mesh_);
    }

private:
    /* Statements of a kind that is remarkable. */
    struct Remark {
        std::string keyword; /* in quotes */
        std::uint64_t count = 0;
        std::size_t line = 0; /* of the first */
    };
    static constexpr std::size_t MOST_LISTED = 8;

    void read_statement(std::string_view keyword)
    {
        if (keyword == "v")
            read_position();
        else if (keyword == "vn")
            read_vector(mesh_.normals, places_.normals, "normal");
        else if (keyword == "vt")
            read_uv();
        else if (keyword == "f" || keyword == "fo") /* the name of old */
            read_face();
        else if (keyword == "l")
            read_line();
        else
            pass_over(keyword);
    }

    Error error(const std::string &what) const { return error_at(statements_.line(), what); }
    Error error_at(std::size_t line, const std::string &what) const
    {
        return Error(path_ + ":" + std::to_string(line), what);
    }

    void read_vector(std::vector<double> &out, std::vector<std::size_t> &places, const char *noun)
    {
        if (words_.size() < 4)
            throw error(std::string("a ") + noun + " needs 3 numbers, here are " + std::to_string(words_.size() - 1) +
                        "; is the file truncated?");
        for (std::size_t k = 1; k <= 3; ++k) {
            const auto value = parse_double(words_[k]);
            if (!value)
                throw error(in_quotes(words_[k]) + " is not a number; correct this " + noun);
            if (overflowed(words_[k], *value))
                throw error(in_quotes(words_[k]) + " is too large for a double; correct this " + noun);
            out.push_back(*value);
        }
        places.push_back(static_cast<std::size_t>(words_[1].data() - source_.text.data()));
    }

    /* v x y z, then w, or r g b, or r g b a */
    void read_position()
    {
        read_vector(mesh_.positions, places_.positions, "vertex");
        if (words_.size() == 5 && number_or(4, 1) != 1)
            beyond_.insert("weights of vertices");
        const bool has_colour = words_.size() >= 7;
        if (has_colour && mesh_.colours.empty())
            mesh_.colours.assign(4 * (mesh_.vertex_count() - 1), 1.0f);
        if (mesh_.colours.empty() && !has_colour)
            return;
        for (std::size_t k = 4; k < 8; ++k)
            mesh_.colours.push_back(has_colour ? drawable(number_or(k, 1)) : 1.0f);
        mesh_.has_alpha = mesh_.has_alpha || words_.size() >= 8;
    }

    void read_uv()
    {
        for (std::size_t k = 1; k <= 2; ++k)
            mesh_.uvs.push_back(drawable(number_or(k, 0)));
        if (words_.size() > 3 && number_or(3, 0) != 0)
            beyond_.insert("third texture coordinates");
    }

    /* Of numbers that are kept as they are, so that they need not be right. */
    double number_or(std::size_t word, double otherwise) const
    {
        const auto value = word < words_.size() ? parse_double(words_[word]) : std::nullopt;
        return value && std::isfinite(*value) ? *value : otherwise;
    }

    void pass_over(std::string_view keyword)
    {
        const std::string between_blanks = " " + std::string(keyword) + " ";
        for (const Beyond &known : BEYOND)
            if (known.keywords.find(between_blanks) != std::string_view::npos) {
                beyond_.insert(known.what);
                return;
            }
        const std::string quoted = in_quotes(keyword);
        const auto same = [&](const Remark &remark) { return remark.keyword == quoted; };
        auto found = std::find_if(unknown_.begin(), unknown_.end(), same);
        if (found == unknown_.end() && unknown_.size() < MOST_LISTED)
            found = unknown_.insert(unknown_.end(), {quoted, 0, statements_.line()});
        ++(found == unknown_.end() ? unlisted_ : found->count);
    }

    void read_face()
    {
        if (words_.size() < 4) {
            if (short_faces_.count++ == 0)
                short_faces_.line = statements_.line();
            return;
        }
        for (std::size_t k = 1; k < words_.size(); ++k)
            read_corner(words_[k]);
        mesh_.face_starts.push_back(mesh_.corners.size());
        face_lines_.push_back(statements_.line());
    }

    /* v, v/vt, v//vn or v/vt/vn */
    void read_corner(std::string_view corner)
    {
        std::string_view part[3];
        std::size_t count = 0, begin = 0;
        for (std::size_t slash = 0; slash != std::string_view::npos; begin = slash + 1) {
            slash = corner.find('/', begin);
            if (count == 3)
                throw error(in_quotes(corner) + " has too many slashes; write v, v/vt, v//vn or v/vt/vn");
            part[count++] = corner.substr(begin, slash == std::string_view::npos ? slash : slash - begin);
        }
        mesh_.corners.push_back(index(part[0], corner, mesh_.vertex_count(), "vertex"));
        mesh_.corner_uvs.push_back(part[1].empty() ? NONE : uv_index(part[1], corner));
        mesh_.corner_normals.push_back(part[2].empty() ? NONE
                                                       : index(part[2], corner, mesh_.normal_count(), "normal"));
    }

    /* OBJ counts from 1, and backwards from -1 = the last one so far. Whether a positive one exists is known at the
     * end of the file. */
    std::uint32_t index(std::string_view word, std::string_view corner, std::size_t count, const char *noun) const
    {
        const auto number = parse_integer(word);
        if (!number || *number == 0)
            throw error("the corner " + in_quotes(corner) + " has no " + noun +
                        " number; numbers start at 1 or at -1");
        if (*number < 0 && static_cast<std::uint64_t>(-(*number + 1)) >= count)
            throw error("the face has " + std::string(noun) + " " + std::to_string(*number) + ", but only " +
                        std::to_string(count) + " come before it; correct the index");
        const std::uint32_t zero_based = from_zero(*number, count);
        if (zero_based == NONE)
            throw error("the face has " + std::string(noun) + " " + std::to_string(*number) +
                        ", which is past the last one; correct the index");
        return zero_based;
    }

    /* A texture coordinate that does not exist harms nobody: it counts as none. */
    std::uint32_t uv_index(std::string_view word, std::string_view corner) const
    {
        const auto number = parse_integer(word);
        if (!number)
            throw error(in_quotes(corner) + " is no corner; write v, v/vt, v//vn or v/vt/vn with whole numbers");
        return from_zero(*number, mesh_.uvs.size() / 2);
    }

    static std::uint32_t from_zero(std::int64_t number, std::size_t count)
    {
        const std::int64_t index = number > 0 ? number - 1 : number + static_cast<std::int64_t>(count);
        return number == 0 || index < 0 || index >= NONE ? NONE : static_cast<std::uint32_t>(index);
    }

    /* l v v v ..., each perhaps with a texture coordinate: its numbers are kept as they are, right or wrong. */
    void read_line()
    {
        std::uint32_t before = NONE;
        for (std::size_t k = 1; k < words_.size(); ++k) {
            const auto number = parse_integer(words_[k].substr(0, words_[k].find('/')));
            const std::uint32_t vertex = from_zero(number.value_or(0), mesh_.vertex_count());
            if (before != NONE && vertex != NONE)
                mesh_.lines.emplace_back(before, vertex);
            before = vertex;
        }
    }

    void check_indices() const
    {
        for (std::size_t face = 0; face < mesh_.face_count(); ++face)
            for (std::size_t corner = mesh_.face_starts[face]; corner < mesh_.face_starts[face + 1]; ++corner) {
                const std::uint32_t vertex = mesh_.corners[corner], normal = mesh_.corner_normals[corner];
                if (vertex >= mesh_.vertex_count())
                    throw past_the_last(face, "vertex", vertex, mesh_.vertex_count());
                if (normal != NONE && normal >= mesh_.normal_count())
                    throw past_the_last(face, "normal", normal, mesh_.normal_count());
            }
    }

    Error past_the_last(std::size_t face, const char *noun, std::uint32_t index, std::size_t count) const
    {
        return error_at(face_lines_[face], "the face has " + std::string(noun) + " " + std::to_string(index + 1ull) +
                                               ", but the last is " + std::to_string(count) + "; correct the index");
    }

    void settle_lines()
    {
        const auto is_wrong = [&](const Edge &line) {
            return std::max(line.first, line.second) >= mesh_.vertex_count();
        };
        mesh_.lines.erase(std::remove_if(mesh_.lines.begin(), mesh_.lines.end(), is_wrong), mesh_.lines.end());
    }

    /* The numbers of the corners go where they say nothing: number i is that of vertex i, or nothing is numbered. */
    void settle_numbers(std::vector<std::uint32_t> &numbers, std::size_t count) const
    {
        for (std::uint32_t &number : numbers)
            if (number >= count)
                number = NONE;
        if (count == 0 || (count == mesh_.vertex_count() && numbers == mesh_.corners))
            numbers.clear();
    }

    /* Some programs write colours from 0 to 255. */
    void settle_colours()
    {
        float largest = 0;
        for (float component : mesh_.colours)
            largest = std::max(largest, component);
        for (std::size_t i = 0; i < mesh_.colours.size(); ++i)
            if (largest > 1 && (i % 4 != 3 || mesh_.has_alpha))
                mesh_.colours[i] /= 255;
        for (float &component : mesh_.colours)
            component = std::clamp(component, 0.0f, 1.0f);
    }

    void settle_remarks()
    {
        if (short_faces_.count > 0)
            mesh_.warnings.push_back(counted(short_faces_.count, "face") +
                                     " of fewer than three corners, the first in line " +
                                     std::to_string(short_faces_.line) + ": " + ONLY_KEPT);
        std::string listed;
        for (const Remark &unknown : unknown_)
            listed += (listed.empty() ? "" : ", ") + grouped(unknown.count) + " " + unknown.keyword +
                      (unknown.count > 1 ? " from line " : " in line ") + std::to_string(unknown.line);
        if (unlisted_ > 0)
            listed += " and " + grouped(unlisted_) + " of other kinds";
        if (!listed.empty()) {
            mesh_.notes.push_back("unknown statements, passed over: " + listed);
            beyond_.insert("unknown statements");
        }
        mesh_.beyond.assign(beyond_.begin(), beyond_.end());
    }

    SourceText source_;
    ObjStatements statements_;
    ObjSource::Places places_;
    std::string path_;
    std::vector<std::string_view> words_;
    Mesh mesh_;
    std::vector<std::size_t> face_lines_;
    Remark short_faces_;
    std::vector<Remark> unknown_;
    std::uint64_t unlisted_ = 0;
    std::set<std::string> beyond_;
};

} // namespace

Mesh read_obj(const std::string &contents, const std::string &path)
{
    return ObjReader(contents, path).read();
}

} // namespace motorway::tool
