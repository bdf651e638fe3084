// The JSON of motion files: what is read, what is refused and how that is said, and how long it takes.

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "json.h"
#include "json_field.h"
#include "motion_file.h"
#include "run_tool.h"

namespace motorway::tool {
namespace {

std::string error_of(const std::string &contents)
{
    try {
        parse_json(contents, "f");
    } catch (const Error &error) {
        return error.what();
    }
    return "no error";
}

/* ---------------------------------------------------------------------------------------------- what is wrong --- */

struct Mistake {
    std::string name, contents;
    std::string begins; /* of the message */
    std::string also = "";
};

void PrintTo(const Mistake &mistake, std::ostream *out)
{
    *out << mistake.name;
}

const std::vector<Mistake> MISTAKES = {
    {"Empty", "", "f:1:1: the file is empty"},
    {"OnlySpace", "\n \n", "f:3:1: the file is empty"},
    {"OnlyByteOrderMark", "\xef\xbb\xbf", "f:1:2: the file is empty"},
    {"CommaBeforeBracket", "[1,\n2,\n]", "f:2:2: [1]: a comma before ']'; remove it"},
    {"CommaBeforeBrace", "{\"a\": 1 , }", "f:1:9: a: a comma before '}'; remove it"},
    {"CommaOfTheIssue", R"({"controls":[{"quaternion":[0,0,0,1]},{"quaternion":[1,0,0,0]},]})",
     "f:1:63: controls[1]: a comma before ']'; remove it"},
    {"CommaFirst", "[, 1]", "f:1:2: [0]: found ',' where a value belongs"},
    {"TwoCommas", "[1,,2]", "f:1:4: [1]: found ',' where a value belongs"},
    {"NoComma", "[1 2]", "f:1:4: [0]: a comma is missing before '2'; add it"},
    {"NoCommaBetweenKeys", "{\"a\": 1\n\"b\": 2}", "f:2:1: a: a comma is missing before '\"'"},
    {"Semicolon", "[1; 2]", "f:1:3: [0]: found ';' where a comma or ']' belongs"},
    {"NoColon", R"({"a" 1})", "f:1:6: found '1' where a ':' belongs, after the key \"a\""},
    {"EqualsSign", R"({"a" = 1})", "f:1:6: found '=' where a ':' belongs"},
    {"NoValue", R"({"a": })", "f:1:7: a: found '}' where a value belongs"},
    {"KeyWithoutQuotes", "{a: 1}", "f:1:2: found \"a\" where a key in double quotes belongs"},
    {"KeyInSingleQuotes", "{'a': 1}", "f:1:2: found ''' where a key in double quotes belongs"},
    {"KeyOfANumber", "{1: 1}", "f:1:2: found \"1\" where a key in double quotes belongs"},
    {"TextInSingleQuotes", R"({"a": 'b'})", "f:1:7: a: found ''' where a value belongs", "texts in \"\""},
    {"TextInCurlyQuotes", "[\xe2\x80\x9c" "a\xe2\x80\x9d]", "f:1:2: [0]: found '\xe2\x80\x9c' where a value belongs"},
    {"Comment", "{ // no\n}", "f:1:3: '/', and JSON has no comments; remove it"},
    {"CommentAfterAComma", "[1, /* two */ 2]", "f:1:5: [0]: '/', and JSON has no comments"},
    {"CommentOfAShell", "# a motion\n{}", "f:1:1: '#', and JSON has no comments"},
    {"WrongBracket", "{\"a\":\n[1}\n}", "f:2:3: a[0]: found '}', and the '[' of line 2 is open; close it with ']'"},
    {"WrongBrace", "{\"a\": 1]", "f:1:8: a: found ']', and the '{' of line 1 is open; close it with '}'"},
    {"Unopened", "]", "f:1:1: found ']' where a value belongs"},
    {"TruncatedList", "[\n1,\n2", "f:3:2: [1]: the file ends here, and the '[' of line 1 is open; is it truncated?"},
    {"TruncatedAfterAComma", "[1,", "f:1:4: [1]: the file ends here"},
    {"TruncatedAfterAKey", R"({"a")", "f:1:5: the file ends here, and the '{' of line 1 is open"},
    {"TruncatedAfterAColon", R"({"a":)", "f:1:6: a: the file ends here"},
    {"TruncatedText", "[\"abc", "f:1:2: [0]: this text has no closing quote in its line"},
    {"TextOverLines", "[\"abc\n\"]", "f:1:2: [0]: this text has no closing quote in its line"},
    {"TwoDocuments", "{}\n{}", "f:2:1: '{' after the end of the document; remove it"},
    {"BracketTooMany", "[]]", "f:1:3: ']' after the end of the document"},
    {"Word", "[zwei]", "f:1:2: [0]: the word \"zwei\" is not in double quotes"},
    {"TrueOfPython", "[True]", "f:1:2: [0]: found \"True\"; write true"},
    {"NoneOfPython", "[None]", "f:1:2: [0]: found \"None\"; write null"},
    {"LongerThanTrue", "[trueish]", "f:1:2: [0]: the word \"trueish\""},
    {"Nan", "[NaN]", "f:1:2: [0]: \"NaN\" is no number of JSON; numbers are finite"},
    {"Infinity", "[Infinity]", "f:1:2: [0]: \"Infinity\" is no number"},
    {"MinusInfinity", "[-Infinity]", "f:1:2: [0]: \"-Infinity\" is no number"},
    {"PlusSign", "[+1]", "f:1:2: [0]: \"+1\" is no number"},
    {"PointFirst", "[.5]", "f:1:2: [0]: \".5\" is no number"},
    {"PointLast", "[5.]", "f:1:2: [0]: \"5.\" is no number"},
    {"ZeroFirst", "[05]", "f:1:2: [0]: \"05\" is no number"},
    {"MinusAlone", "[-]", "f:1:2: [0]: \"-\" is no number"},
    {"TwoMinuses", "[--1]", "f:1:2: [0]: \"--1\" is no number"},
    {"Hexadecimal", "[0x10]", "f:1:2: [0]: \"0x10\" is no number"},
    {"ExponentMissing", "[1e]", "f:1:2: [0]: \"1e\" is no number"},
    {"TwoPoints", "[1.2.3]", "f:1:2: [0]: \"1.2.3\" is no number"},
    {"Underscore", "[1_000]", "f:1:2: [0]: \"1_000\" is no number"},
    {"Unit", "[5mm]", "f:1:2: [0]: \"5mm\" is no number"},
    {"TooLarge", "[1e400]", "f:1:2: [0]: \"1e400\" is too large a number"},
    {"TooNegative", "[-1e309]", "f:1:2: [0]: \"-1e309\" is too large a number"},
    {"ExponentBeyondAnyNumber", "[1e99999999999999999999]", "f:1:2: [0]: \"1e99999999999999999999\" is too large"},
    {"ManyDigits", "[" + std::string(100000, '9') + "]",
     "f:1:2: [0]: \"" + std::string(40, '9') + "...\" is too large"},
    {"NulAtTheStart", std::string("\0{}", 3), "f:1:1: found the byte 0x00 where a value belongs"},
    {"NulInAText", std::string("[\"a\0\"]", 6), "f:1:4: [0]: the byte 0x00 in a text"},
    {"NulAtTheEnd", std::string("{}\0", 3), "f:1:3: the byte 0x00 after the end"},
    {"TabInAText", "[\"\t\"]", "f:1:3: [0]: the byte 0x09 in a text", "\\t"},
    {"FormFeed", "[\f1]", "f:1:2: [0]: found the byte 0x0c where a value belongs"},
    {"NoBreakSpace", "[\xc2\xa0" "1]", "f:1:2: [0]: found '\xc2\xa0' where a value belongs"},
    {"Latin1", "[\"Stra\xdf" "e\"]", "f:1:7: [0]: the byte 0xdf is no UTF-8"},
    {"Utf8CutShort", "[\"\xe2\x82\"]", "f:1:3: [0]: the byte 0xe2 is no UTF-8"},
    {"Utf8TooLong", "[\"\xc0\xaf\"]", "f:1:3: [0]: the byte 0xc0 is no UTF-8"},
    {"Utf8Surrogate", "[\"\xed\xa0\x80\"]", "f:1:3: [0]: the byte 0xed is no UTF-8"},
    {"Utf8BeyondUnicode", "[\"\xf4\x90\x80\x80\"]", "f:1:3: [0]: the byte 0xf4 is no UTF-8"},
    {"InvalidByteOutside", "[\xff]", "f:1:2: [0]: found the byte 0xff where a value belongs"},
    {"Utf16", "\xff\xfe{", "f:1:1: the file is in UTF-16; save it as UTF-8"},
    {"Utf16BigEndian", "\xfe\xff", "f:1:1: the file is in UTF-16"},
    {"UnknownEscape", R"(["C:\motion"])", "f:1:5: [0]: no escape of JSON", "\\\\"},
    {"EscapeAtTheEnd", "[\"\\", "f:1:3: [0]: no escape of JSON"},
    {"ShortUnicodeEscape", R"(["\u12g4"])", "f:1:3: [0]: \\u needs 4 hexadecimal digits"},
    {"HighSurrogateAlone", R"(["\ud83dx"])", "f:1:3: [0]: half of a surrogate pair"},
    {"LowSurrogateAlone", R"(["\ude00"])", "f:1:3: [0]: half of a surrogate pair"},
    {"TwoHighSurrogates", R"(["\ud83d\ud83d"])", "f:1:3: [0]: half of a surrogate pair"},
    {"KeyTwice", R"({"a": 1, "b": 2, "a": 3, "b": 4})", "f:1:18: the key \"a\" comes twice here; keep one"},
    {"KeyTwiceByAnEscape", R"({"a": 1, "\u0061": 2})", "f:1:10: the key \"a\" comes twice"},
    {"KeyTwiceInside", "{\"c\": [{},\n{\"a\": 1, \"a\": 2}]}", "f:2:10: c[1]: the key \"a\" comes twice"},
    {"TooDeep", std::string(17, '['), "f:1:17: [0][0]", "nested more than 16 deep"},
    {"TooDeepWhereItDoesNotMatter", "[" + std::string(17, '[') + std::string(17, ']') + "]", "f:1:17: ", "16 deep"},
    {"ColumnsAreCharacters", "[\"\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\" 1]", "f:1:8: [0]: a comma is missing"},
    {"LinesOfWindows", "[1,\r\n2,\r\n]", "f:2:2: [1]: a comma before"},
    {"LinesOfOldMacs", "[1,\r2,\r]", "f:2:2: [1]: a comma before"},
    {"StrangeKeysStayOnOneLine", "{\"a\\nb\\u0007\": [1,]}", "f:1:18: [\"a?b?\"][0]: a comma before"},
};

class JsonMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(JsonMistakes, AreSaidWithTheirPlace)
{
    const std::string message = error_of(GetParam().contents);
    EXPECT_EQ(message.rfind(GetParam().begins, 0), 0u) << message;
    EXPECT_NE(message.find(GetParam().also), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
}

INSTANTIATE_TEST_SUITE_P(, JsonMistakes, ::testing::ValuesIn(MISTAKES),
                         [](const auto &mistake) { return mistake.param.name; });

/* ------------------------------------------------------------------------------------------------ what is good --- */

TEST(Json, ReadsEveryKindOfValue)
{
    const Document document =
        parse_json("\xef\xbb\xbf\r\n{\"\": [], \"a\": {\"b\": [1, [true, false, null], \"\"]} }\t\n", "f");
    const Field b = Field(document)["a"]["b"];
    ASSERT_EQ(b.array().size(), 3u);
    EXPECT_EQ(b.array()[0].number(), 1);
    EXPECT_TRUE(b.array()[1].array()[0].boolean());
    EXPECT_FALSE(b.array()[1].array()[1].boolean());
    EXPECT_EQ(b.array()[2].string(), "");
    EXPECT_EQ(std::string(b.array()[1].array()[2].error("is here").what()), "f:2: a.b[1][2]: is here");
}

TEST(Json, ReadsNumbers)
{
    const Document document = parse_json("[0, -0, -12, 0.5, 1e-3, 12.5E+2, 0e99, 1e-400, 123456789012345678901]", "f");
    EXPECT_EQ(Field(document).numbers(),
              (std::vector<double>{0, 0, -12, 0.5, 1e-3, 1250, 0, 0, 123456789012345678901.0}));
}

TEST(Json, ReadsTexts)
{
    const Document document = parse_json(
        R"(["\"\\\/\b\f\n\r\t", "\u0041\u00e4\u20ac\ud83d\ude00\u0000", "[[[[[[[[[[[[[[[[[[[[", "// no comment",)"
        "\"\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\"]",
        "f");
    const std::vector<Field> texts = Field(document).array();
    ASSERT_EQ(texts.size(), 5u);
    EXPECT_EQ(texts[0].string(), "\"\\/\b\f\n\r\t");
    EXPECT_EQ(texts[1].string(), std::string("A\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\0", 11));
    EXPECT_EQ(texts[2].string(), "[[[[[[[[[[[[[[[[[[[[");
    EXPECT_EQ(texts[3].string(), "// no comment");
    EXPECT_EQ(texts[4].string(), "\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80");
}

TEST(Json, ReadsSixteenLevels)
{
    EXPECT_EQ(error_of(std::string(16, '[') + std::string(16, ']')), "no error");
}

/* ------------------------------------------------------------------------------------------------- how long --- */

std::string repeated(const std::string &text, std::size_t count)
{
    std::string all;
    for (std::size_t k = 0; k < count; ++k)
        all += text;
    return all;
}

/* Megabytes: what is quadratic in them takes hours, which is more than a test may, and what is linear a second. They are
 * made when their test runs: GoogleTest prints all parameters of a program each time that it starts. */
constexpr std::size_t MANY = 4000000;
const std::string HEAD = R"({"motorway": 2, "scheme": "additive", "degree": 1, )";

std::string many_keys()
{
    std::string keys = "{";
    for (int k = 0; k < 300000; ++k)
        keys += "\"k" + std::to_string(k) + "\": 1, ";
    return keys + "\"k0\": 1}";
}

using Megabytes = std::pair<const char *, std::string (*)()>;
const Megabytes MEGABYTES[] = {
    {"Lists", [] { return std::string(MANY, '['); }},
    {"Objects", [] { return repeated("{\"a\":", MANY / 5); }},
    {"ClosedLists", [] { return std::string(MANY / 2, '[') + std::string(MANY / 2, ']'); }},
    {"EmptyLists", [] { return "[" + repeated("[],", MANY / 3) + "]"; }},
    {"Digits", [] { return HEAD + "\"mesh_size\": " + std::string(MANY, '1') + "}"; }},
    {"Decimals", [] { return HEAD + "\"mesh_size\": 1." + std::string(MANY, '1') + "}"; }},
    {"Text", [] { return HEAD + "\"name\": \"" + std::string(MANY, '[') + "\"}"; }},
    {"Key", [] { return "{\"" + std::string(MANY, 'k') + "\": 1}"; }},
    {"Keys", many_keys},
    {"Knots", [] { return HEAD + "\"knots\": [" + repeated("1,", MANY / 2) + "1], \"controls\": [{\"steps\": []}]}"; }},
    {"Controls", [] { return HEAD + "\"controls\": [" + repeated("{\"steps\": []}, ", MANY / 15) + "{}]}"; }},
};

class JsonOfMegabytes : public ::testing::TestWithParam<Megabytes> {};

TEST_P(JsonOfMegabytes, TakesTimeInProportion)
{
    EXPECT_THROW(parse_motion(GetParam().second(), "f"), Error);
}

INSTANTIATE_TEST_SUITE_P(, JsonOfMegabytes, ::testing::ValuesIn(MEGABYTES),
                         [](const auto &input) { return std::string(input.param.first); });

} // namespace
} // namespace motorway::tool
