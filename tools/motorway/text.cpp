#include "text.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace motorway::tool {

/* strtof and not from_chars: the latter is missing for floats in some standard libraries that are still in use.
 * Nothing in the tool calls setlocale, so a decimal point is a point. */
template <class T> static std::optional<T> parse_real(std::string_view word, T (*convert)(const char *, char **))
{
    char *end = nullptr;
    if (word.empty())
        return std::nullopt;
    const T value = convert(word.data(), &end);
    if (end != word.data() + word.size())
        return std::nullopt;
    return value;
}

std::optional<float> parse_float(std::string_view word)
{
    return parse_real<float>(word, std::strtof);
}

std::optional<double> parse_double(std::string_view word)
{
    return parse_real<double>(word, std::strtod);
}

bool overflowed(std::string_view word, double value)
{
    return std::isinf(value) && word.find_first_of("0123456789") != std::string_view::npos;
}

std::optional<std::int64_t> parse_integer(std::string_view word)
{
    std::int64_t value = 0;
    if (word.size() > 1 && word[0] == '+' && word[1] != '-')
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

template <class T> static void append_shortest(std::string &text, T value)
{
    if (std::isnan(value)) { /* whose sign says nothing, and is nothing that every reader takes */
        text += "nan";
        return;
    }
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append_number(std::string &text, float value)
{
    append_shortest(text, value);
}

void append_number(std::string &text, double value)
{
    append_shortest(text, value);
}

std::string grouped(std::uint64_t value)
{
    std::string digits = std::to_string(value);
    for (std::size_t k = digits.size(); k > 3; k -= 3)
        digits.insert(k - 3, ",");
    return digits;
}

std::string grouped(double value)
{
    return grouped(static_cast<std::uint64_t>(std::llround(value)));
}

std::string brief(double value, int digits)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string precise(double value)
{
    std::string text;
    append_number(text, value);
    return text;
}

std::string byte_size(std::uintmax_t bytes)
{
    const double kilobytes = static_cast<double>(bytes) / 1000;
    char digits[32];
    if (kilobytes < 1000)
        std::snprintf(digits, sizeof digits, kilobytes < 100 ? "%.2f kB" : "%.0f kB", kilobytes);
    else
        std::snprintf(digits, sizeof digits, "%.2f MB", kilobytes / 1000);
    return digits;
}

std::string counted(std::uint64_t count, const std::string &noun)
{
    if (count == 1)
        return "1 " + noun;
    if (noun == "vertex")
        return grouped(count) + " vertices";
    return grouped(count) + " " + noun + (noun.back() == 's' ? "es" : "s");
}

/* What could be written shorter, surrogates, and what is beyond Unicode are no characters. */
std::size_t utf8_length(std::string_view text)
{
    constexpr std::uint32_t SMALLEST[] = {0x80, 0x800, 0x10000}, LARGEST = 0x10ffff;
    const auto byte = [&](std::size_t k) { return std::uint32_t{static_cast<unsigned char>(text[k])}; };
    if (text.empty())
        return 0;
    if (byte(0) < 0x80)
        return 1;
    const std::size_t length = byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : 4;
    if (byte(0) < 0xc0 || byte(0) >= 0xf8 || text.size() < length)
        return 0;
    std::uint32_t code_point = byte(0) & (0x7f >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xc0) != 0x80)
            return 0;
        code_point = code_point << 6 | (byte(k) & 0x3f);
    }
    const bool is_surrogate = code_point >= 0xd800 && code_point <= 0xdfff;
    return code_point < SMALLEST[length - 2] || code_point > LARGEST || is_surrogate ? 0 : length;
}

std::string in_quotes(std::string_view words)
{
    constexpr std::size_t LONGEST = 40;
    std::string safe = "\"";
    std::size_t at = 0;
    while (at < words.size() && at < LONGEST) {
        const std::size_t length = utf8_length(words.substr(at));
        const bool is_control = length == 1 && (static_cast<unsigned char>(words[at]) < ' ' || words[at] == 0x7f);
        safe += length == 0 || is_control ? "?" : words.substr(at, length);
        at += length == 0 ? 1 : length;
    }
    return safe + (at < words.size() ? "...\"" : "\"");
}

} // namespace motorway::tool
