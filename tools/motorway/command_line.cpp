#include "command_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "text.h"

namespace motorway::tool {
namespace {

using Words = std::vector<std::string>;

/* "a, b and c" */
std::string enumerated(const Words &words, const char *conjunction)
{
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k)
        text += (k == 0 ? "" : k + 1 < words.size() ? ", " : std::string(" ") + conjunction + " ") + words[k];
    return text;
}

/* ------------------------------------------------------------------------------------------------ near words --- */

/* Without dashes in front, in small letters. */
std::string bare(std::string word)
{
    word.erase(0, std::min(word.find_first_not_of('-'), word.size()));
    for (char &c : word)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return word;
}

/* How many letters are wrong, missing, too many, or in the place of their neighbours. */
std::size_t distance(const std::string &a, const std::string &b)
{
    std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            std::size_t &best = table[i][j] = i + j;
            if (i == 0 || j == 0)
                continue;
            best = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1, table[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                best = std::min(best, table[i - 2][j - 2] + 1);
        }
    return table[a.size()][b.size()];
}

/* The word that was meant, or none: one letter in three may be wrong, or the end may be missing. */
std::string nearest(const std::string &word, const Words &known)
{
    constexpr std::size_t LONGEST = 40;
    const std::string given = bare(word);
    std::string found;
    std::size_t smallest = std::max<std::size_t>(given.size() / 3, 1);
    if (given.size() < 2 || given.size() > LONGEST)
        return found;
    for (const std::string &name : known) {
        const bool begins_so = bare(name).compare(0, given.size(), given) == 0;
        const std::size_t apart = begins_so ? 1 : distance(given, bare(name));
        if (apart < smallest || (apart == smallest && found.empty())) {
            found = name;
            smallest = apart;
        }
    }
    return found;
}

/* ------------------------------------------------------------------------------------------------- mistakes --- */

Words names_of_commands(const CLI::App &app)
{
    Words names;
    for (const CLI::App *command : app.get_subcommands([](const CLI::App *) { return true; }))
        names.push_back(command->get_name());
    return names;
}

Words names_of_options(const CLI::App &command)
{
    Words names;
    for (const CLI::Option *option : command.get_options())
        for (const std::string &name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

/* "--frames N", or of what stands alone "MESH". */
std::string usage_of(const CLI::Option &option)
{
    return option.get_positional() ? option.get_name() : option.get_name() + " " + option.get_type_name();
}

/* Words that `command` does not know; it is the app itself where they stand before a command. Options are named first,
 * for what follows one may be its value; but a command comes before all that belongs to it. */
std::string unknown_word(const CLI::App &app, const CLI::App &command, const Words &words)
{
    const auto is_option = [](const std::string &word) { return word.size() > 1 && word[0] == '-'; };
    const bool in_front = &command == &app, about_commands = in_front && !is_option(words.front());
    const auto option = std::find_if(words.begin(), words.end(), is_option);
    const std::string word = about_commands || option == words.end() ? words.front() : *option;
    if (option == words.end() && !in_front)
        return in_quotes(word) + " is one argument too many; remove it";
    const Words commands = names_of_commands(app), options = names_of_options(command);
    Words known = options;
    if (in_front)
        known.insert(known.begin(), commands.begin(), commands.end());
    const std::string near = nearest(word.substr(0, word.find('=')), known);
    const Words &there = about_commands ? commands : options;
    return in_quotes(word) + (about_commands ? " is no command" : " is no option") +
           (near.empty() ? "" : ", but " + near + " is") + (there.size() == 1 ? "; there is " : "; there are ") +
           enumerated(there, "and") + (in_front && !about_commands ? ", and options of a command come after it" : "");
}

/* An option that took the next option for its value, or nothing. */
std::string swallowed_option(const CLI::App &command)
{
    for (const CLI::Option *option : command.get_options())
        for (const std::string &value : option->results())
            if (value[0] == '-' && command.get_option_no_throw(value))
                return option->get_name() + ": its value is missing, for " + value + " follows; write " +
                       usage_of(*option);
    return "";
}

std::string wrong_flag(const CLI::App &command, const std::string &message)
{
    for (const CLI::Option *option : command.get_options())
        if (option->get_expected_max() == 0 && message.find(option->get_name()) != message.npos)
            return option->get_name() + ": takes no value; write " + option->get_name() + " alone";
    return message;
}

std::string missing_words(const CLI::App &command)
{
    Words missing, usage = {"motorway " + command.get_name()};
    for (const CLI::Option *option : command.get_options()) {
        if (!option->get_required())
            continue;
        usage.push_back(usage_of(*option));
        if (option->count() == 0)
            missing.push_back(option->get_name());
    }
    std::string line;
    for (const std::string &word : usage)
        line += (line.empty() ? "" : " ") + word;
    return enumerated(missing, "and") + (missing.size() == 1 ? " is" : " are") + " missing; write " + line;
}

std::string wrong_count(const CLI::App &command, const std::string &message)
{
    const std::string name = message.substr(0, message.find(':'));
    const CLI::Option *option = command.get_option_no_throw(name);
    if (!option)
        return message;
    if (option->count() > 1)
        return name + ": is given " + std::to_string(option->count()) + " times; give it once";
    return name + ": its value is missing; write " + usage_of(*option);
}

std::string wrong_option(const CLI::App &command, const CLI::ParseError &problem)
{
    const std::string message = problem.what();
    if (dynamic_cast<const CLI::RequiredError *>(&problem))
        return missing_words(command);
    if (dynamic_cast<const CLI::ArgumentMismatch *>(&problem))
        return wrong_count(command, message);
    if (dynamic_cast<const CLI::ConversionError *>(&problem)) /* of flags: the other values have been checked */
        return wrong_flag(command, message);
    return dynamic_cast<const CLI::RequiresError *>(&problem) ? message + "; add that" : message;
}

} // namespace

CLI::Validator whole_number()
{
    return CLI::Validator(
        [](std::string &word) {
            const bool only_digits = word.find_first_not_of("0123456789", word[0] == '-') == word.npos;
            if (parse_integer(word))
                return std::string();
            return in_quotes(word) + (only_digits && word.size() > 1 ? " is far too large; give fewer digits"
                                                                     : " is no whole number; give one, as 120");
        },
        "");
}

CLI::Validator number()
{
    return CLI::Validator(
        [](std::string &word) {
            return parse_double(word) ? std::string() : in_quotes(word) + " is no number; give one, as 0.5";
        },
        "");
}

CLI::Validator one_of(const std::vector<std::string> &words)
{
    return CLI::Validator(
        [words](std::string &word) {
            return std::find(words.begin(), words.end(), word) != words.end()
                       ? std::string()
                       : in_quotes(word) + " is none; give " + enumerated(words, "or");
        },
        "{" + CLI::detail::join(words, ",") + "}");
}

std::string describe_mistake(const CLI::App &app, const CLI::ParseError &problem)
{
    const std::vector<CLI::App *> given = app.get_subcommands();
    const Words in_front = app.remaining(), unknown = app.remaining(true);
    const bool before_a_command = given.empty() || !in_front.empty();
    const CLI::App &command = before_a_command ? app : *given.front();
    std::string mistake = swallowed_option(command); /* the cause of whatever else is wrong */
    if (!mistake.empty())
        return mistake;
    if (!unknown.empty() && unknown.front() != "--")
        mistake = unknown_word(app, command, before_a_command ? in_front : unknown);
    else if (before_a_command)
        mistake = "there is no command; give one of " + enumerated(names_of_commands(app), "and");
    else
        mistake = wrong_option(command, problem);
    return mistake + "; see motorway " + (before_a_command ? "" : command.get_name() + " ") + "--help";
}

} // namespace motorway::tool
