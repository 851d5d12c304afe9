// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GrowthActions.h"

#include "ui/base/Actions.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/workspace/Workspace.h"

#include <QAbstractButton>
#include <QLabel>

namespace ui {

namespace {

struct Press {
    const char* id;
    const char* button;
    const char* text;
    const char* keys; ///< null: none
    const char* why; ///< null: what the panel advises
};

constexpr const char* nothingGrown = "Nothing has grown yet that could be taken back";

const Press presses[] = {
    {"grow.play", "growPlay", "Grow, or pause", "G", nullptr},
    {"grow.step", "growStep", "Grow by one generation", "Shift+G", nullptr},
    {"grow.toClosure", "growToClosure", "Grow until nothing is left", "Ctrl+G", nullptr},
    {"grow.resume", "growResume", "Resume the growth before", nullptr,
        "There is no growth to go on with yet"},
    {"grow.shrink", "growShrink", "Shrink by one generation", "Shift+X", nothingGrown},
    {"grow.toSeeds", "growToSeeds", "Shrink to the seeds", nullptr, nothingGrown},
};

void carryOut(const Press& press, const GrowthPanel& panel, Workspace& workspace)
{
    auto* button = panel.findChild<QAbstractButton*>(QLatin1String(press.button));
    if (button->isEnabled())
        button->click();
    else if (press.why)
        workspace.say(QString::fromUtf8(press.why));
    else
        workspace.say(panel.findChild<QLabel*>(QStringLiteral("growAdvice"))->text());
}

} // namespace

QStringList addGrowthActions(Actions& actions, GrowthPanel& panel, Workspace& workspace)
{
    QStringList ids;
    for (const Press& press : presses) {
        Actions::Entry entry{.id = QString::fromLatin1(press.id),
            .text = QString::fromUtf8(press.text),
            .run = [&press, &panel, &workspace] { carryOut(press, panel, workspace); },
            .possible = [&workspace] { return workspace.session() != nullptr; }};
        if (press.keys)
            entry.keys = {QKeySequence(QString::fromLatin1(press.keys))};
        ids += entry.id;
        actions.add(std::move(entry));
    }
    return ids;
}

} // namespace ui
