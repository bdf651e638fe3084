#include "obj.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "error.h"
#include "text.h"

namespace motorway::tool {
namespace {

/* Statements that are allowed and passed over, with what gets lost. */
struct PassedOver {
    std::string_view keywords; /* each between blanks */
    const char *loss;
};
constexpr PassedOver PASSED_OVER[] = {
    {" vt ", "texture coordinates"},
    {" usemtl mtllib usemap maplib ", "materials"},
    {" o g s mg ", "groups"},
    {" p ", "points"},
    {" l ", "lines"},
    {" lod bevel c_interp d_interp shadow_obj trace_obj ", "display attributes"},
    {" vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con ctech stech ", "free-form geometry"},
};

/* The words of one statement after the other, with comments gone and continued lines joined. */
class Statements {
public:
    explicit Statements(std::string_view text) : text_(text) {}

    bool next(std::vector<std::string_view> &words)
    {
        words.clear();
        while (words.empty() && position_ < text_.size()) {
            line_ = next_line_;
            read_line(words);
            while (!words.empty() && words.back() == "\\") {
                words.pop_back();
                read_line(words);
            }
        }
        return !words.empty();
    }

    std::size_t line() const { return line_; }

private:
    void read_line(std::vector<std::string_view> &words)
    {
        const std::size_t end = std::min(text_.find('\n', position_), text_.size());
        const std::string_view line = text_.substr(position_, end - position_);
        position_ = std::min(end + 1, text_.size());
        ++next_line_;
        constexpr std::string_view BLANKS = " \t\r\v\f";
        std::size_t begin = line.find_first_not_of(BLANKS);
        while (begin != std::string_view::npos && line[begin] != '#') {
            const std::size_t stop = std::min(line.find_first_of(BLANKS, begin), line.size());
            words.push_back(line.substr(begin, stop - begin));
            begin = line.find_first_not_of(BLANKS, stop);
        }
    }

    std::string_view text_;
    std::size_t position_ = 0, line_ = 0, next_line_ = 1;
};

class ObjReader {
public:
    ObjReader(const std::string &contents, const std::string &path) : statements_(contents), path_(path) {}

    Mesh read()
    {
        while (statements_.next(words_)) {
            if (words_[0] == "v")
                read_position();
            else if (words_[0] == "vn")
                read_vector(mesh_.normals, "normal");
            else if (words_[0] == "f")
                read_face();
            else
                pass_over();
        }
        check_indices();
        settle_normals();
        mesh_.left_out.assign(left_out_.begin(), left_out_.end());
        return std::move(mesh_);
    }

private:
    Error error(const std::string &what) const { return error_at(statements_.line(), what); }
    Error error_at(std::size_t line, const std::string &what) const
    {
        return Error(path_ + ":" + std::to_string(line), what);
    }

    void read_vector(std::vector<float> &out, const char *noun)
    {
        if (words_.size() < 4)
            throw error(std::string("a ") + noun + " needs 3 numbers, here are " + std::to_string(words_.size() - 1) +
                        "; is the file truncated?");
        for (std::size_t k = 1; k <= 3; ++k) {
            const auto value = parse_float(words_[k]);
            if (!value)
                throw error(in_quotes(words_[k]) + " is not a number; correct this " + noun);
            if (!std::isfinite(*value))
                throw error(in_quotes(words_[k]) + " is not a finite float; correct this " + noun);
            out.push_back(*value);
        }
    }

    void read_position()
    {
        read_vector(mesh_.positions, "vertex");
        if (words_.size() >= 7)
            left_out_.insert("vertex colours");
    }

    void pass_over()
    {
        const std::string keyword = " " + std::string(words_[0]) + " ";
        for (const PassedOver &passed : PASSED_OVER)
            if (passed.keywords.find(keyword) != std::string_view::npos) {
                left_out_.insert(passed.loss);
                return;
            }
        throw error(in_quotes(words_[0]) + " is no OBJ statement; is this an OBJ file?");
    }

    void read_face()
    {
        if (words_.size() < 4)
            throw error("a face needs 3 corners or more, here are " + std::to_string(words_.size() - 1) +
                        "; is the file truncated?");
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
        if (!part[1].empty() && !parse_integer(part[1]))
            throw error(in_quotes(corner) + " is no corner; write v, v/vt, v//vn or v/vt/vn with whole numbers");
        if (!part[2].empty())
            mesh_.corner_normals.push_back(index(part[2], corner, mesh_.normal_count(), "normal"));
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
        const std::int64_t zero_based = *number > 0 ? *number - 1 : static_cast<std::int64_t>(count) + *number;
        if (zero_based >= std::numeric_limits<std::uint32_t>::max())
            throw error("the face has " + std::string(noun) + " " + std::to_string(*number) +
                        ", which is past the last one; correct the index");
        return static_cast<std::uint32_t>(zero_based);
    }

    void check_indices() const
    {
        const bool all_normals = mesh_.corner_normals.size() == mesh_.corners.size();
        for (std::size_t face = 0; face < mesh_.face_count(); ++face)
            for (std::size_t corner = mesh_.face_starts[face]; corner < mesh_.face_starts[face + 1]; ++corner) {
                if (mesh_.corners[corner] >= mesh_.vertex_count())
                    throw past_the_last(face, "vertex", mesh_.corners[corner], mesh_.vertex_count());
                if (all_normals && mesh_.corner_normals[corner] >= mesh_.normal_count())
                    throw past_the_last(face, "normal", mesh_.corner_normals[corner], mesh_.normal_count());
            }
    }

    Error past_the_last(std::size_t face, const char *noun, std::uint32_t index, std::size_t count) const
    {
        return error_at(face_lines_[face], "the face has " + std::string(noun) + " " + std::to_string(index + 1ull) +
                                               ", but the last is " + std::to_string(count) + "; correct the index");
    }

    /* Normals count only if every corner has one. */
    void settle_normals()
    {
        if (mesh_.corner_normals.size() != mesh_.corners.size()) {
            if (!mesh_.normals.empty())
                left_out_.insert("normals (not every corner has one)");
            mesh_.normals.clear();
            mesh_.corner_normals.clear();
        }
        if (mesh_.normal_count() == mesh_.vertex_count() && mesh_.corner_normals == mesh_.corners)
            mesh_.corner_normals.clear();
    }

    Statements statements_;
    std::string path_;
    std::vector<std::string_view> words_;
    Mesh mesh_;
    std::vector<std::size_t> face_lines_;
    std::set<std::string> left_out_;
};

void append_vectors(std::string &text, const char *keyword, const std::vector<float> &vectors)
{
    for (std::size_t i = 0; i < vectors.size(); i += 3) {
        text += keyword;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            text += ' ';
            append_number(text, vectors[i + axis]);
        }
        text += '\n';
    }
}

} // namespace

Mesh read_obj(const std::string &contents, const std::string &path)
{
    return ObjReader(contents, path).read();
}

std::string write_obj(const Mesh &mesh, const std::vector<float> &positions, const std::vector<float> &normals)
{
    std::string text = "# motorway\n";
    append_vectors(text, "v", positions);
    append_vectors(text, "vn", normals);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        text += 'f';
        for (std::size_t corner = mesh.face_starts[face]; corner < mesh.face_starts[face + 1]; ++corner) {
            const std::uint32_t vertex = mesh.corners[corner];
            const std::uint32_t normal = mesh.corner_normals.empty() ? vertex : mesh.corner_normals[corner];
            text += ' ' + std::to_string(vertex + 1ull) + "//" + std::to_string(normal + 1ull);
        }
        text += '\n';
    }
    return text;
}

} // namespace motorway::tool
