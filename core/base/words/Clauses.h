// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QStringList>

#include <initializer_list>
#include <utility>
#include <vector>

namespace core {

/// The arguments of an error: clauses and plain texts. They are read one by one, and changed only
/// as wholes, so that no text of a clause parts from its form.
class Clauses {
public:
    Clauses() = default;
    Clauses(std::initializer_list<Clause> clauses)
        : m_clauses(clauses)
    {
    }

    /// Plain texts.
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

    /// Empty where there is none.
    [[nodiscard]] Clause value(qsizetype i) const;

    /// Those from a place on.
    [[nodiscard]] Clauses mid(qsizetype from) const;

    /// The English texts.
    operator QStringList() const;

    /// The English texts, one behind the other.
    template <class Separator> [[nodiscard]] QString join(const Separator& separator) const
    {
        return QStringList(*this).join(separator);
    }

    /// There may be fewer so far.
    void set(qsizetype i, Clause clause);
    void append(Clause clause) { m_clauses.push_back(std::move(clause)); }
    void prepend(Clause clause) { m_clauses.insert(m_clauses.begin(), std::move(clause)); }
    Clauses& operator+=(Clause clause);

    /// Another text for one wherever it occurs, also within the arguments of clauses.
    void replace(const QString& before, const QString& after);

    /// Another text for every argument that is one as a whole.
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
