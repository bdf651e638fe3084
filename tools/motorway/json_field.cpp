#include "json_field.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "text.h"

namespace motorway::tool {
namespace {

/* Reads a document for its mistakes: where it stops being JSON, and keys that come twice, of which nlohmann::json
 * would silently keep the last. It keeps the path of the field it is in and nothing else. */
class Proofreader : public nlohmann::json_sax<nlohmann::json> {
public:
    Proofreader(const std::string &contents, const std::string &file) : contents_(contents), file_(file) {}

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
        if (!levels_.back().keys.insert(name).second)
            throw Error(file_ + ": " + path(), "the key " + in_quotes(name) + " comes twice here; keep one");
        levels_.back().key = name;
        return true;
    }

    bool parse_error(std::size_t position, const std::string &token,
                     const nlohmann::json::exception &problem) override
    {
        const std::size_t end = std::min(position, contents_.size());
        const auto line =
            1 + std::count(contents_.begin(), contents_.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        const std::string place = path().empty() ? "" : "at " + path() + ": ";
        /* 406 is a number that no double holds. */
        const std::string what = problem.id == 406 ? in_quotes(token) + " is too large a number; write a smaller one"
                                                   : "not JSON from " + in_quotes(token) +
                                                         " on; numbers are finite and decimal, words in quotes";
        throw Error(file_ + ":" + std::to_string(line), place + what);
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
        levels_.push_back({is_array, 0, "", {}});
        return true;
    }
    bool end()
    {
        levels_.pop_back();
        return value();
    }
    bool value()
    {
        if (!levels_.empty())
            ++levels_.back().index;
        return true;
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
    std::vector<Level> levels_;
};

} // namespace

nlohmann::json parse_json(const std::string &contents, const std::string &path)
{
    Proofreader proofreader(contents, path);
    nlohmann::json::sax_parse(contents, &proofreader);
    return nlohmann::json::parse(contents);
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
        throw error("unknown key " + in_quotes(item.key()) + "; the keys here are " + known);
    }
}

Field Field::operator[](const char *key) const
{
    const auto found = value_->find(key);
    if (found == value_->end())
        throw error("the key \"" + std::string(key) + "\" is missing; add it");
    return Field(*found, file_, (path_.empty() ? "" : path_ + ".") + key);
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
        fields.emplace_back((*value_)[i], file_, path_ + "[" + std::to_string(i) + "]");
    return fields;
}

std::vector<double> Field::numbers(std::size_t count) const
{
    std::vector<double> values;
    for (const Field &field : array())
        values.push_back(field.number());
    if (values.size() != count)
        throw error("must hold " + std::to_string(count) + " numbers, and holds " + std::to_string(values.size()) +
                    "; correct it");
    return values;
}

} // namespace motorway::tool
