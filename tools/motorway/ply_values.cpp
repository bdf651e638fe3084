#include "ply_values.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "text.h"

namespace motorway::tool {
namespace {

std::string at_row(const std::string &name, std::uint64_t row)
{
    return "in " + name + " " + std::to_string(row) + " (counting from 0) ";
}

class AsciiValues : public PlyValues {
public:
    AsciiValues(const PlyHeader &header, const std::string &text, std::size_t position, const std::string &path)
        : text_(text), path_(path), begin_(position), position_(position), next_line_(header.body_line),
          line_(header.body_line)
    {
    }

    double real(PlyType type, const std::string &name, std::uint64_t row) override
    {
        const std::string_view word = next(name, row);
        /* A float is read as one: by way of a double it could be rounded twice. */
        const auto single = type == PlyType::float32 ? parse_float(word) : std::nullopt;
        const auto value = single ? std::optional<double>(*single) : parse_double(word);
        if (!value)
            throw error(name, row, in_quotes(word) + " is not a number; correct it");
        if (overflowed(word, *value))
            throw error(name, row, in_quotes(word) + " is too large for its type; correct it");
        return *value;
    }

    void skip(PlyType, std::uint64_t count, const std::string &name, std::uint64_t row) override
    {
        for (std::uint64_t k = 0; k < count; ++k)
            next(name, row);
    }

    std::size_t begin() const override { return begin_; }
    std::size_t end() const override { return position_; }

    std::int64_t integer(PlyType, const std::string &name, std::uint64_t row) override
    {
        const std::string_view word = next(name, row);
        const auto value = parse_integer(word);
        if (!value)
            throw error(name, row, in_quotes(word) + " is not a whole number; correct it");
        return *value;
    }

    void check_room(PlyType, std::uint64_t count, const std::string &name, std::uint64_t row) override
    {
        if (count > (text_.size() - position_ + 1) / 2)
            throw truncated(name, row);
    }

    Error error(const std::string &name, std::uint64_t row, const std::string &what) const override
    {
        return Error(path_ + ":" + std::to_string(line_), at_row(name, row) + what);
    }

    std::size_t line() const override { return line_; }

private:
    Error truncated(const std::string &name, std::uint64_t row) const
    {
        return error(name, row, "the file ends; is it truncated?");
    }

    std::string_view next(const std::string &name, std::uint64_t row)
    {
        while (position_ < text_.size() && is_blank(text_[position_]))
            next_line_ += text_[position_++] == '\n';
        line_ = next_line_;
        begin_ = position_;
        while (position_ < text_.size() && !is_blank(text_[position_]))
            ++position_;
        if (begin_ == position_)
            throw truncated(name, row);
        return text_.substr(begin_, position_ - begin_);
    }

    static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    std::string_view text_;
    std::string path_;
    std::size_t begin_, position_, next_line_, line_;
};

class BinaryValues : public PlyValues {
public:
    BinaryValues(const PlyHeader &header, const std::string &text, std::size_t position, const std::string &path)
        : text_(text), path_(path), begin_(position), position_(position),
          big_endian_(header.format == PlyFormat::big_endian)
    {
    }

    double real(PlyType type, const std::string &name, std::uint64_t row) override
    {
        if (type == PlyType::uint64)
            return static_cast<double>(next(ply_size(type), name, row));
        if (ply_is_integer(type))
            return static_cast<double>(integer(type, name, row));
        const std::uint64_t bits = next(ply_size(type), name, row);
        if (type == PlyType::float32) {
            const std::uint32_t half = static_cast<std::uint32_t>(bits);
            float value;
            std::memcpy(&value, &half, sizeof value);
            return value;
        }
        double value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }

    std::int64_t integer(PlyType type, const std::string &name, std::uint64_t row) override
    {
        const std::uint64_t bits = next(ply_size(type), name, row);
        switch (type) {
        case PlyType::int8:
            return static_cast<std::int8_t>(bits);
        case PlyType::int16:
            return static_cast<std::int16_t>(bits);
        case PlyType::int32:
            return static_cast<std::int32_t>(bits);
        default:
            return static_cast<std::int64_t>(bits);
        }
    }

    void skip(PlyType type, std::uint64_t count, const std::string &name, std::uint64_t row) override
    {
        check_room(type, count, name, row);
        begin_ = position_;
        position_ += count * ply_size(type);
    }

    std::size_t begin() const override { return begin_; }
    std::size_t end() const override { return position_; }

    void check_room(PlyType type, std::uint64_t count, const std::string &name, std::uint64_t row) override
    {
        if (count > (text_.size() - position_) / ply_size(type))
            throw truncated(name, row);
    }

    Error error(const std::string &name, std::uint64_t row, const std::string &what) const override
    {
        return Error(path_, at_row(name, row) + what);
    }

private:
    Error truncated(const std::string &name, std::uint64_t row) const
    {
        return error(name, row, "the file ends; is it truncated?");
    }

    std::uint64_t next(std::size_t size, const std::string &name, std::uint64_t row)
    {
        if (size > text_.size() - position_)
            throw truncated(name, row);
        begin_ = position_;
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const auto byte = static_cast<unsigned char>(text_[position_ + (big_endian_ ? k : size - 1 - k)]);
            bits = bits << 8 | byte;
        }
        position_ += size;
        return bits;
    }

    std::string_view text_;
    std::string path_;
    std::size_t begin_, position_;
    bool big_endian_;
};

} // namespace

std::unique_ptr<PlyValues> ply_values(const PlyHeader &header, const std::string &text, std::size_t position,
                                      const std::string &path)
{
    if (header.format == PlyFormat::ascii)
        return std::make_unique<AsciiValues>(header, text, position, path);
    return std::make_unique<BinaryValues>(header, text, position, path);
}

} // namespace motorway::tool
