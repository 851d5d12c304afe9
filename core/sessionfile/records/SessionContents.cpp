// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionContents.h"

#include <QStringList>

#include <algorithm>

namespace core {

namespace {

/// A name that may be damaged itself, fit to be shown.
QString shown(const QString& name)
{
    constexpr int longest = 60;
    QString text = name.simplified();
    text.removeIf([](QChar letter) { return !letter.isPrint(); });
    return text.size() > longest ? text.left(longest) + QStringLiteral("…") : text;
}

} // namespace

QString SessionDamage::text() const
{
    if (row == 0)
        return QStringLiteral("where it stood cannot be read: %1").arg(reason);
    QString rows = QStringLiteral("row %1").arg(row);
    if (const QString known = shown(name); !known.isEmpty())
        rows += QStringLiteral(" '%1'").arg(known);
    if (after < 0)
        rows += QStringLiteral(" and all after it");
    else if (after == 1)
        rows += QStringLiteral(" and the one after it");
    else if (after > 1)
        rows += QStringLiteral(" and the %1 after it").arg(after);
    return QStringLiteral("%1 cannot be read: %2").arg(rows, reason);
}

std::vector<QString> SessionContents::problems() const
{
    std::vector<QString> sentences;
    if (damage)
        sentences.push_back(damage->text());
    if (redo.size() == 1) {
        sentences.push_back(
            QStringLiteral("what row %1 '%2' changed cannot be read (%3); it can be carried out "
                           "again")
                .arg(redo.front().row)
                .arg(shown(redo.front().name), redo.front().reason));
    } else if (!redo.empty()) {
        QStringList numbers;
        for (const SessionDamage& row : redo)
            numbers += QString::number(row.row);
        sentences.push_back(
            QStringLiteral("what the rows %1 changed cannot be read; they can be carried out again")
                .arg(numbers.join(QStringLiteral(", "))));
    }
    const auto tells = [this](const QString& told) { return told.contains(cutOff); };
    if (!cutOff.isEmpty() && std::none_of(sentences.begin(), sentences.end(), tells))
        sentences.push_back(damage ? cutOff : QStringLiteral("%1; no row is lost").arg(cutOff));
    if (!leftOpen.isEmpty())
        sentences.push_back(leftOpen);
    return sentences;
}

void SessionContents::cut(const SessionDamage& at)
{
    damage = at;
    if (at.row > 0)
        rows.resize(std::min(rows.size(), std::size_t(at.row - 1)));
    const auto last = RowId(rows.size());
    if (position < 0 || position > last) {
        position = last;
        positionLost = true;
    }
    visited.erase(std::remove_if(visited.begin(), visited.end(),
                      [this, last](const std::pair<RowId, RowId>& step) {
                          const auto [parent, child] = step;
                          return child <= 0 || child > last
                              || rows[std::size_t(child - 1)].parent != parent;
                      }),
        visited.end());
    redo.erase(std::remove_if(redo.begin(), redo.end(),
                   [last](const SessionDamage& lost) { return lost.row > last; }),
        redo.end());
    keyframes.erase(std::remove_if(keyframes.begin(), keyframes.end(),
                        [last](const Keyframe& keyframe) { return keyframe.row > last; }),
        keyframes.end());
}

} // namespace core
