// SPDX-License-Identifier: Apache-2.0
#include "core/base/words/Clause.h"

#include "core/base/words/Said.h"

#include <QStringList>

namespace core {

namespace {

QString englishOf(const char* form, const std::vector<Clause>& arguments)
{
    return filledIn(QString::fromUtf8(form), QStringList(arguments.begin(), arguments.end()));
}

} // namespace

Clause::Clause(const char* form, std::vector<Clause> arguments)
    : QString(englishOf(form, arguments))
    , m_made(std::make_shared<const Made>(Made{.form = form, .arguments = std::move(arguments)}))
{
}

const char* Clause::form() const
{
    return m_made ? m_made->form : nullptr;
}

const std::vector<Clause>& Clause::arguments() const
{
    static const std::vector<Clause> none;
    return m_made ? m_made->arguments : none;
}

Clause Clause::replaced(const QString& before, const QString& after) const
{
    if (!m_made)
        return QString(*this).replace(before, after);
    std::vector<Clause> texts;
    texts.reserve(m_made->arguments.size());
    for (const Clause& each : m_made->arguments)
        texts.push_back(each.replaced(before, after));
    return {m_made->form, std::move(texts)};
}

} // namespace core
