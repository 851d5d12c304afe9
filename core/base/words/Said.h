// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <variant>
#include <vector>

namespace core {

/// A sentence for people, or a part of one, as a code with arguments: core hands it over in this
/// form, and the window and the command line put it into words (ui/texts).
/// @tparam Code an enumeration of everything that is said about one subject
template <class Code> struct Said {
    /// A list of sentences or parts, with the word or mark (`joiner`) that stands between two of
    /// them.
    struct Listed {
        Code joiner{};
        std::vector<Said> all{};
        bool operator==(const Listed& other) const
        {
            return joiner == other.joiner && all == other.all;
        }
    };
    /// One of
    /// - a count; as the first argument of a sentence it selects the singular or the plural form;
    /// - a clause or plain text: a name, or a number in the form in which it is shown;
    /// - a list of sentences that are inserted.
    using Argument = std::variant<std::int64_t, Clause, Listed>;

    Code code{};
    std::vector<Argument> arguments{};
    // Not defaulted, because the type contains itself.
    bool operator==(const Said& other) const
    {
        return code == other.code && arguments == other.arguments;
    }
};

/// How one language words the sentences of a subject.
template <class Code> class SaidLanguage {
public:
    virtual ~SaidLanguage() = default;

    /// The form of a sentence, with %1 … for its arguments.
    /// @param count the first argument, if it is a count, else 0
    [[nodiscard]] virtual QString form(Code code, std::int64_t count) const = 0;

    /// A clause in this language. By default it stays English.
    [[nodiscard]] virtual QString clause(const Clause& clause) const { return clause.english(); }
};

/// Replaces %1 … %9 in a form by the arguments, in one pass: text of an argument that looks like a
/// place (such as "%2") stays as it is, and so do places without an argument.
[[nodiscard]] QString filledIn(const QString& text, const QStringList& arguments);

template <class Code>
[[nodiscard]] QString worded(const Said<Code>& said, const SaidLanguage<Code>& language);

/// Turns one argument into text. Used by worded().
template <class Code> struct WordedArgument {
    const SaidLanguage<Code>& language;

    QString operator()(std::int64_t count) const { return QString::number(count); }
    QString operator()(const Clause& clause) const { return language.clause(clause); }
    QString operator()(const typename Said<Code>::Listed& listed) const
    {
        QStringList texts;
        for (const Said<Code>& each : listed.all)
            texts += worded(each, language);
        return texts.join(language.form(listed.joiner, 0));
    }
};

template <class Code> QString worded(const Said<Code>& said, const SaidLanguage<Code>& language)
{
    QStringList arguments;
    for (const auto& argument : said.arguments)
        arguments += std::visit(WordedArgument<Code>{language}, argument);
    const auto* count =
        said.arguments.empty() ? nullptr : std::get_if<std::int64_t>(&said.arguments.front());
    return filledIn(language.form(said.code, count ? *count : 0), arguments);
}

} // namespace core
