// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/KeysDialog.h"

#include "ui/base/Actions.h"
#include "ui/base/MenuText.h"
#include "ui/base/Theme.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ui {

namespace {

struct Binding {
    const char* input;
    const char* slice;
    const char* volume;
};

// UX §4.3.
const Binding bindings[] = {
    {"Left drag, no tool", "grey scale (width, level)", "turn"},
    {"Left drag or pen, with a tool", "the tool", "the tool, on the surface that is seen"},
    {"Space + left drag", "pan", "turn"},
    {"Click, no tool", "crosshair here", "on the cube: look from that side"},
    {"Drag a ring on the crosshair, no tool", "turns the other slices; Ctrl: only that one", ""},
    {"Shift + move", "crosshair follows", ""},
    {"Middle drag", "pan", "pan"},
    {"Right drag", "zoom; grey scale with a tool", "zoom"},
    {"Ctrl + right drag", "grey scale from the values in a box", ""},
    {"Right click", "menu of the place and its segment", "the same, where one is seen"},
    {"Wheel", "slices; Shift: five at a time", "zoom"},
    {"Ctrl + wheel", "zoom", "zoom"},
    {"Ctrl + Shift + wheel", "thickness of the slab", "depth of the tool"},
    {"Ctrl + wheel, with drill or laser", "", "turn of the mask"},
    {"Ctrl held, with most tools", "the reverse: paint erases, carve restores",
        "the reverse: paint erases, carve restores"},
    {"H held", "looks under the segments", "the same"},
    {"Pen's eraser end, with most tools", "the same as Ctrl", "the same as Ctrl"},
    {"Shift + wheel, with a tool", "radius", "radius"},
    {"Pen's lower button + drag", "pan", "pan"},
    {"Pen's upper button + drag", "zoom; grey scale with a tool", "zoom"},
    {"Pen's upper button, pressed", "menu of the place", "menu of the place"},
    {"Double click", "this view alone, or all four", "this view alone, or all four"},
    {"Double click, with a tool", "two clicks of the tool; Space held: this view alone",
        "two clicks of the tool; Space held: this view alone"},
    {"Z held", "lens: what is under the pointer, three times as large", ""},
    {"Up, Down, Page Up, Page Down", "one slice; ten slices", ""},
    {"Home, End", "first, last slice", ""},
    {"Tab", "the tool before, and back again", "the same"},
    {"Esc", "takes back the stroke under the pen", "the same, and what is not kept yet"},
};

} // namespace

KeysDialog::KeysDialog(const Actions& actions, QWidget* parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Mouse, pen and keys"));
    auto* list = new QTreeWidget(this);
    list->setColumnCount(3);
    list->setHeaderLabels({tr("Input"), tr("In a slice"), QStringLiteral("In 3D")});
    list->setRootIsDecorated(false);
    list->setSelectionMode(QAbstractItemView::NoSelection);
    list->setFocusPolicy(Qt::NoFocus);
    for (const Binding& binding : bindings) {
        new QTreeWidgetItem(list,
            {QString::fromUtf8(binding.input), QString::fromUtf8(binding.slice),
                QString::fromUtf8(binding.volume)});
    }
    auto* heading = new QTreeWidgetItem(list, {tr("Anywhere")});
    heading->setFont(0, theme::headingFont());
    for (const QAction* action : actions.all()) {
        if (action->shortcuts().isEmpty())
            continue;
        const QString keys =
            QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText);
        new QTreeWidgetItem(list, {keys, plainText(action->text())});
    }
    // As wide as what they hold: nothing is cut.
    constexpr int gap = 16;
    int width = 2 * gap + style()->pixelMetric(QStyle::PM_ScrollBarExtent) + gap;
    for (int column = 0; column < list->columnCount(); ++column) {
        list->resizeColumnToContents(column);
        list->setColumnWidth(column, list->columnWidth(column) + gap);
        width += list->columnWidth(column);
    }
    resize(width, 640);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addWidget(list);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace ui
