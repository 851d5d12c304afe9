// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QStringList>

#include <initializer_list>
#include <utility>
#include <vector>

namespace core {

/// The arguments of an error: clauses and plain texts. They can be read one by one but replaced
/// only as wholes, so that the text of a clause always agrees with its form.
class Clauses {
public:
    Clauses() = default;
    Clauses(std::initializer_list<Clause> clauses)
        : m_clauses(clauses)
    {
    }

    /// Each text becomes a plain clause.
    Clauses(const QStringList& texts)
        : m_clauses(texts.begin(), texts.end())
    {
    }

    [[nodiscard]] qsizetype size() const { return qsizetype(m_clauses.size()); }
    [[nodiscard]] bool isEmpty() const { return m_clauses.empty(); }
    [[nodiscard]] auto begin() const { return m_clauses.begin(); }
    [[nodiscard]] auto end() const { return m_clauses.end(); }
    [[nodiscard]] Clause front() const { return m_clauses.front(); }
    [[nodiscard]] Clause operator[](qsizetype i) const { return m_clauses[std::size_t(i)]; }

    /// The clause at a position, or an empty one if there is none.
    [[nodiscard]] Clause value(qsizetype i) const;

    /// The clauses from position @p from to the end.
    [[nodiscard]] Clauses mid(qsizetype from) const;

    /// The English texts.
    operator QStringList() const;

    /// The English texts, joined with a separator.
    template <class Separator> [[nodiscard]] QString join(const Separator& separator) const
    {
        return QStringList(*this).join(separator);
    }

    /// Sets the clause at a position. If there are fewer so far, empty ones are added in between.
    void set(qsizetype i, Clause clause);
    void append(Clause clause) { m_clauses.push_back(std::move(clause)); }
    void prepend(Clause clause) { m_clauses.insert(m_clauses.begin(), std::move(clause)); }
    Clauses& operator+=(Clause clause);

    /// Replaces a text wherever it occurs in plain texts and in arguments of clauses
    /// (Clause::replaced()).
    void replace(const QString& before, const QString& after);

    /// Replaces every argument whose whole text is @p before.
    void exchange(const QString& before, const QString& after);

    friend bool operator==(const Clauses& one, const Clauses& other)
    {
        return QStringList(one) == QStringList(other);
    }
    friend bool operator==(const Clauses& one, const QStringList& other)
    {
        return QStringList(one) == other;
    }

private:
    std::vector<Clause> m_clauses;
};

} // namespace core
