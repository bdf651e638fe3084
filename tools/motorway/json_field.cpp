#include "json_field.h"

#include <algorithm>
#include <cmath>
#include <ios>
#include <set>
#include <sstream>

#include "text.h"

namespace motorway::tool {
namespace {

/* motion.json:3: controls[0].motor */
std::string place(const std::string &file, std::size_t line, const std::string &path)
{
    return file + (line ? ":" + std::to_string(line) : "") + (path.empty() ? "" : ": " + path);
}

/* Reads a document for its mistakes: where it stops being JSON, and keys that come twice, of which nlohmann::json
 * would silently keep the last. It keeps the path of the field it is in, and the line of every field. */
class Proofreader : public nlohmann::json_sax<nlohmann::json> {
public:
    Proofreader(const std::string &contents, const std::string &file, std::map<std::string, std::size_t> &lines)
        : contents_(contents), file_(file), lines_(lines), stream_(contents)
    {
    }

    void read() { nlohmann::json::sax_parse(stream_, this); }

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool number_integer(number_integer_t) override { return value(); }
    bool number_unsigned(number_unsigned_t) override { return value(); }
    bool number_float(number_float_t, const string_t &) override { return value(); }
    bool string(string_t &) override { return value(); }
    bool binary(binary_t &) override { return value(); }

    bool start_object(std::size_t) override { return begin(false); }
    bool start_array(std::size_t) override { return begin(true); }
    bool end_object() override { return end(); }
    bool end_array() override { return end(); }

    bool key(string_t &name) override
    {
        levels_.back().key.clear();
        if (!levels_.back().keys.insert(name).second)
            throw Error(place(file_, line(), path()), "the key " + in_quotes(name) + " comes twice here; keep one");
        levels_.back().key = name;
        return true;
    }

    bool parse_error(std::size_t position, const std::string &token,
                     const nlohmann::json::exception &problem) override
    {
        const std::size_t end = std::min(position, contents_.size());
        const auto line =
            1 + std::count(contents_.begin(), contents_.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        const std::string field = path().empty() ? "" : "at " + path() + ": ";
        /* 406 is a number that no double holds. */
        const std::string what = problem.id == 406 ? in_quotes(token) + " is too large a number; write a smaller one"
                                                   : "not JSON from " + in_quotes(token) +
                                                         " on; numbers are finite and decimal, words in quotes";
        throw Error(file_ + ":" + std::to_string(line), field + what);
    }

private:
    struct Level {
        bool is_array;
        std::size_t index;
        std::string key;
        std::set<std::string> keys;
    };

    bool begin(bool is_array)
    {
        lines_[path()] = line();
        levels_.push_back({is_array, 0, "", {}});
        return true;
    }
    bool end()
    {
        levels_.pop_back();
        return next();
    }
    bool value()
    {
        lines_[path()] = line();
        return next();
    }
    bool next()
    {
        if (!levels_.empty())
            ++levels_.back().index;
        return true;
    }

    /* The line of what was just read. To find the end of a number the character after it is read too, which may be
     * the end of the line: so the last character read does not count. */
    std::size_t line()
    {
        const std::streamoff read = stream_.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
        for (; counted_ + 1 < read; ++counted_)
            line_ += contents_[static_cast<std::size_t>(counted_)] == '\n';
        return line_;
    }

    std::string path() const
    {
        std::string text;
        for (const Level &level : levels_) {
            if (level.is_array)
                text += "[" + std::to_string(level.index) + "]";
            else if (!level.key.empty())
                text += (text.empty() ? "" : ".") + level.key;
        }
        return text;
    }

    const std::string &contents_;
    const std::string &file_;
    std::map<std::string, std::size_t> &lines_;
    std::istringstream stream_;
    std::vector<Level> levels_;
    std::streamoff counted_ = 0; /* how many characters line_ has been counted over */
    std::size_t line_ = 1;
};

} // namespace

Document parse_json(const std::string &contents, const std::string &path)
{
    Document document;
    document.file = path;
    Proofreader(contents, document.file, document.lines).read();
    document.value = nlohmann::json::parse(contents);
    return document;
}

Error Field::error(const std::string &what) const
{
    return error_at(path_, what);
}

/* Fields that the file does not have, but implies, have no line. */
Error Field::error_at(const std::string &path, const std::string &what) const
{
    const auto found = document_->lines.find(path);
    return Error(place(document_->file, found == document_->lines.end() ? 0 : found->second, path_), what);
}

std::string Field::path_of(const char *key) const
{
    return (path_.empty() ? "" : path_ + ".") + key;
}

Error Field::wrong_type(const char *wanted) const
{
    return error(std::string("must be ") + wanted + ", and is " + value_->type_name() + "; correct it");
}

void Field::check_object(std::initializer_list<const char *> keys) const
{
    if (!value_->is_object())
        throw wrong_type("an object in braces");
    for (const auto &item : value_->items()) {
        const auto is_key = [&](const char *key) { return item.key() == key; };
        if (std::any_of(keys.begin(), keys.end(), is_key))
            continue;
        std::string known;
        for (const char *key : keys)
            known += (known.empty() ? "" : ", ") + std::string(key);
        throw error_at(path_of(item.key().c_str()),
                       "unknown key " + in_quotes(item.key()) + "; the keys here are " + known);
    }
}

Field Field::operator[](const char *key) const
{
    if (!value_->is_object())
        throw wrong_type("an object in braces");
    const auto found = value_->find(key);
    if (found == value_->end())
        throw error("the key \"" + std::string(key) + "\" is missing; add it");
    return Field(*found, *document_, path_of(key));
}

double Field::number() const
{
    if (!value_->is_number())
        throw wrong_type("a number");
    const double number = value_->get<double>();
    if (!std::isfinite(static_cast<float>(number)))
        throw error("is too large for a float; write a smaller number");
    return number;
}

long long Field::integer() const
{
    const double rounded = std::nearbyint(number());
    if (rounded != number() || std::abs(rounded) > 1e9)
        throw error("must be a whole number; correct it");
    return static_cast<long long>(rounded);
}

bool Field::boolean() const
{
    if (!value_->is_boolean())
        throw wrong_type("true or false");
    return value_->get<bool>();
}

std::string Field::string() const
{
    if (!value_->is_string())
        throw wrong_type("a text in quotes");
    return value_->get<std::string>();
}

std::vector<Field> Field::array() const
{
    if (!value_->is_array())
        throw wrong_type("a list in brackets");
    std::vector<Field> fields;
    for (std::size_t i = 0; i < value_->size(); ++i)
        fields.push_back(Field((*value_)[i], *document_, path_ + "[" + std::to_string(i) + "]"));
    return fields;
}

std::vector<double> Field::numbers() const
{
    std::vector<double> values;
    for (const Field &field : array())
        values.push_back(field.number());
    return values;
}

std::vector<double> Field::numbers(std::size_t count) const
{
    std::vector<double> values = numbers();
    if (values.size() != count)
        throw error("must hold " + std::to_string(count) + " numbers, and holds " + std::to_string(values.size()) +
                    "; correct it");
    return values;
}

} // namespace motorway::tool
