// SPDX-License-Identifier: Apache-2.0
#include "core/base/words/Clauses.h"

#include <algorithm>

namespace core {

Clause Clauses::value(qsizetype i) const
{
    return i >= 0 && i < size() ? m_clauses[std::size_t(i)] : Clause();
}

Clauses::operator QStringList() const
{
    QStringList texts;
    for (const Clause& clause : m_clauses)
        texts += clause.english();
    return texts;
}

Clauses Clauses::mid(qsizetype from) const
{
    Clauses rest;
    for (qsizetype i = std::max<qsizetype>(0, from); i < size(); ++i)
        rest.append(m_clauses[std::size_t(i)]);
    return rest;
}

void Clauses::set(qsizetype i, Clause clause)
{
    if (i >= size())
        m_clauses.resize(std::size_t(i) + 1);
    m_clauses[std::size_t(i)] = std::move(clause);
}

Clauses& Clauses::operator+=(Clause clause)
{
    append(std::move(clause));
    return *this;
}

void Clauses::replace(const QString& before, const QString& after)
{
    for (Clause& clause : m_clauses)
        clause = clause.replaced(before, after);
}

void Clauses::exchange(const QString& before, const QString& after)
{
    for (Clause& clause : m_clauses) {
        if (clause == before)
            clause = after;
    }
}

} // namespace core
