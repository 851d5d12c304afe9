// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace core {

/// A part of a sentence that gives a reason, such as "piece 3 of 9 of its images is no piece". As a
/// QString it is the English text, which goes into logs, files and the pipes of worker processes.
/// In addition it remembers the form from which that text was made and the arguments that were
/// filled in, so that `ui` can word it in another language (ui::clauseText()).
///
/// A clause that is passed on as a QString, or that has gone through a pipe or a file, loses its
/// form: it is plain text from then on and is shown as it is.
///
/// Forms are extracted for translation by lupdate of Qt 6 with `-tr-function-alias tr+=saying`. It
/// takes the class before the name as their context, which is "core::Clause", and warns that this
/// class has no Q_OBJECT.
class Clause : public QString {
public:
    Clause() = default;

    /// A plain text that the program did not word itself: the name of a file, the message of a
    /// library.
    template <class Text>
    requires(
        std::convertible_to<Text, QString> && !std::is_base_of_v<Clause, std::remove_cvref_t<Text>>)
        Clause(Text&& text)
        : QString(std::forward<Text>(text))
    {
    }

    /// @param form the canonical English, a literal, with places %1, %2 … for its arguments
    /// @param arguments numbers, texts in the form in which they are shown, and other clauses
    template <std::size_t size, class... Arguments>
    [[nodiscard]] static Clause saying(const char (&form)[size], const Arguments&... arguments)
    {
        return {form, std::vector<Clause>{argument(arguments)...}};
    }

    [[nodiscard]] const QString& english() const { return *this; }

    /// The form without its arguments filled in; null for a plain text.
    [[nodiscard]] const char* form() const;

    [[nodiscard]] const std::vector<Clause>& arguments() const;

    /// A copy in which @p after replaces @p before in plain text and in arguments. Forms are not
    /// searched: the replaced text must not occur in one.
    [[nodiscard]] Clause replaced(const QString& before, const QString& after) const;

    // These would change the text but not the form.
    template <class Text> void operator+=(Text&&) = delete;
    template <class... Arguments> void append(Arguments&&...) = delete;
    template <class... Arguments> void prepend(Arguments&&...) = delete;
    template <class... Arguments> void insert(Arguments&&...) = delete;
    template <class... Arguments> void replace(Arguments&&...) = delete;
    template <class... Arguments> void remove(Arguments&&...) = delete;
    template <class... Arguments> void truncate(Arguments&&...) = delete;
    template <class... Arguments> void chop(Arguments&&...) = delete;
    void clear() = delete;

private:
    struct Made {
        const char* form = nullptr;
        std::vector<Clause> arguments;
    };

    Clause(const char* form, std::vector<Clause> arguments);

    template <class Argument> static Clause argument(const Argument& value)
    {
        if constexpr (std::convertible_to<const Argument&, Clause>)
            return value;
        else
            return QStringLiteral("%1").arg(value);
    }

    std::shared_ptr<const Made> m_made;
};

} // namespace core
