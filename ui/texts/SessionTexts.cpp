// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/SessionTexts.h"

#include "ui/texts/ClauseText.h"

#include <QCoreApplication>

#include <algorithm>

namespace ui {

namespace {

struct SessionTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::SessionTexts)
};

/// A name that may be damaged itself, fit to be shown.
QString shown(const QString& name)
{
    constexpr int longest = 60;
    QString text = name.simplified();
    text.removeIf([](QChar letter) { return !letter.isPrint(); });
    return text.size() > longest ? text.left(longest) + QStringLiteral("…") : text;
}

/// What is to be carried out again.
QString redoText(const std::vector<core::SessionDamage>& redo)
{
    if (redo.size() == 1)
        return SessionTexts::tr("what row %1 '%2' changed cannot be read (%3); it can be carried "
                                "out again")
            .arg(QString::number(redo.front().row), shown(redo.front().name),
                clauseText(redo.front().reason));
    QStringList numbers;
    for (const core::SessionDamage& row : redo)
        numbers += QString::number(row.row);
    return SessionTexts::tr("what the rows %1 changed cannot be read; they can be carried out "
                            "again")
        .arg(numbers.join(SessionTexts::tr(", ")));
}

} // namespace

QString damageText(const core::SessionDamage& damage)
{
    if (damage.row == 0)
        return SessionTexts::tr("where it stood cannot be read: %1").arg(clauseText(damage.reason));
    QString rows = SessionTexts::tr("row %1").arg(damage.row);
    if (const QString known = shown(damage.name); !known.isEmpty())
        rows += SessionTexts::tr(" '%1'").arg(known);
    if (damage.after < 0)
        rows += SessionTexts::tr(" and all after it");
    else if (damage.after == 1)
        rows += SessionTexts::tr(" and the one after it");
    else if (damage.after > 1)
        rows +=
            SessionTexts::tr(" and the %1 after it", nullptr, int(damage.after)).arg(damage.after);
    return SessionTexts::tr("%1 cannot be read: %2").arg(rows, clauseText(damage.reason));
}

QString damageText(const core::Error& error)
{
    const auto rows = core::SessionDamage::of(error);
    return rows ? damageText(*rows) : clauseText(error.arguments.value(1));
}

QStringList problemTexts(const core::SessionContents& contents)
{
    QStringList sentences;
    if (contents.damage)
        sentences += damageText(*contents.damage);
    if (!contents.redo.empty())
        sentences += redoText(contents.redo);
    const QString cutOff = clauseText(contents.cutOff);
    const auto tells = [&cutOff](const QString& told) { return told.contains(cutOff); };
    if (!cutOff.isEmpty() && std::none_of(sentences.begin(), sentences.end(), tells))
        sentences += contents.damage ? cutOff : SessionTexts::tr("%1; no row is lost").arg(cutOff);
    if (!contents.leftOpen.isEmpty())
        sentences += clauseText(contents.leftOpen);
    return sentences;
}

QStringList deidentifiedTexts(const core::DeidentifiedSession& session)
{
    const QString steps = session.steps == 1
        ? SessionTexts::tr("1 step")
        : SessionTexts::tr("%1 steps", nullptr, int(session.steps)).arg(session.steps);
    QStringList sentences{
        SessionTexts::tr("A session of %1 without where its study was, UIDs, authors and pictures; "
                         "%2. Every hash was compared.")
            .arg(steps, session.method)};
    if (session.imagesLeftOut)
        sentences += SessionTexts::tr("The study's images were left out.");
    sentences +=
        SessionTexts::tr("Names of segments, sculpt layers and bookmarks stay as they are.");
    return sentences;
}

} // namespace ui
