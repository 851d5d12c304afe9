// SPDX-License-Identifier: Apache-2.0
#include "ui/window/OptionBar.h"

#include "ui/base/MenuText.h"
#include "ui/base/Theme.h"
#include "ui/input/Tool.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/workspace/Refinement.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr int barHeight = 36;
constexpr int iconPixels = 30; ///< a button without a name, and what surrounds a name
/// The widths that undo and redo may have, the widest first. Names are cut to them; less of a name
/// than the second shows tells nothing.
constexpr std::array<int, 3> stepPixels{190, 124, iconPixels};

QFrame* verticalLine(QWidget* parent)
{
    auto* line = new QFrame(parent);
    line->setFixedSize(1, 20);
    line->setStyleSheet(QStringLiteral("background: %1").arg(theme::line.name()));
    return line;
}

} // namespace

/// As wide as it was told to be, whatever it says; where there is no room, its icon alone, so that
/// it never makes the window wider.
class OptionBar::StepButton final : public QToolButton {
public:
    explicit StepButton(QWidget* parent)
        : QToolButton(parent)
    {
        setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    }
    void setPixels(int pixels)
    {
        if (m_pixels == pixels)
            return;
        m_pixels = pixels;
        updateGeometry();
    }
    [[nodiscard]] QSize sizeHint() const override
    {
        return {m_pixels, QToolButton::sizeHint().height()};
    }
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        return {iconPixels, QToolButton::minimumSizeHint().height()};
    }

private:
    int m_pixels = iconPixels;
};

OptionBar::OptionBar(Workspace& workspace, QAction& undo, QAction& redo, QWidget* parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_layout(new QHBoxLayout(this))
    , m_tool(new QLabel(this))
    , m_keys(new FittingLabel(Qt::AlignRight, this))
{
    setProperty("role", QStringLiteral("bar"));
    setFixedHeight(barHeight);
    m_layout->setContentsMargins(theme::smallPadding, 0, theme::padding, 0);
    m_layout->setSpacing(theme::smallPadding);
    m_layout->addWidget(addAction(undo));
    m_layout->addWidget(addAction(redo));
    m_layout->addWidget(verticalLine(this));
    m_tool->setFont(theme::headingFont());
    m_layout->addSpacing(2);
    m_layout->addWidget(m_tool);
    m_layout->addStretch(1);
    // The first to give way: a tool's options never make the window wider.
    m_keys->setMinimumWidth(1);
    m_keys->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_keys->setObjectName(QStringLiteral("toolKeys"));
    m_keys->setParts(QStringLiteral(" · "));
    m_keys->setProperty("role", QStringLiteral("secondary"));
    m_keys->setFont(theme::smallFont());
    m_keys->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_layout->addWidget(m_keys, 8);
    connect(&workspace, &Workspace::activeToolChanged, this, &OptionBar::showTool);
    connect(&workspace, &Workspace::sessionChanged, this, &OptionBar::showTool);
    // Each way of refining has its own.
    connect(&workspace.refinement(), &Refinement::settingsChanged, this, &OptionBar::showKeys);
    showTool();
}

QToolButton* OptionBar::addAction(QAction& action)
{
    auto* button = new StepButton(this);
    button->setDefaultAction(&action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize(QSize(18, 18));
    button->setFont(theme::smallFont());
    button->setFocusPolicy(Qt::NoFocus);
    // The tool and its options stay where they are, whatever the next step is called.
    m_steps.append(button);
    connect(&action, &QAction::changed, this, &OptionBar::showNames);
    return button;
}

void OptionBar::showNames()
{
    int room = width() - m_layout->minimumSize().width();
    room += iconPixels * int(m_steps.size());
    if (m_options)
        room -= m_options->sizeHint().width() - m_options->minimumSizeHint().width();
    const int each = room / std::max(int(m_steps.size()), 1);
    const auto* fitting = std::find_if(
        stepPixels.begin(), stepPixels.end() - 1, [each](int pixels) { return pixels <= each; });
    const bool named = *fitting > iconPixels;
    for (StepButton* button : m_steps) {
        const QAction& action = *button->defaultAction();
        button->setToolButtonStyle(named ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
        button->setPixels(*fitting);
        button->setText(
            button->fontMetrics().elidedText(action.text(), Qt::ElideRight, *fitting - iconPixels));
        button->setToolTip(plainText(action.text()) + QStringLiteral("  ")
            + action.shortcut().toString(QKeySequence::NativeText));
    }
}

bool OptionBar::event(QEvent* event)
{
    const bool done = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest)
        showNames();
    return done;
}

void OptionBar::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    showNames();
}

void OptionBar::showTool()
{
    if (m_options) {
        // Out of the way at once, so that both tools' options never add up to the bar's least
        // width; deleted later, since a combo box of it may be in the middle of its own signal.
        m_options->hide();
        m_layout->removeWidget(m_options);
        m_options->deleteLater();
    }
    m_options = nullptr;
    Tool* tool = m_workspace.activeTool();
    if (!m_workspace.volume())
        tool = nullptr;
    m_tool->setVisible(tool != nullptr);
    showKeys();
    if (!tool)
        return;
    connect(tool, &Tool::nameChanged, this, &OptionBar::showKeys, Qt::UniqueConnection);
    m_options = tool->createOptions(this);
    if (m_options) {
        m_layout->insertWidget(m_layout->indexOf(m_tool) + 1, m_options);
        m_options->show();
    }
}

void OptionBar::showKeys()
{
    const Tool* tool = m_workspace.volume() ? m_workspace.activeTool() : nullptr;
    m_tool->setText(tool ? tool->name() : QString());
    m_keys->setText(!m_workspace.volume() ? QString()
            : tool                        ? tool->keys()
                                          : tr("left grey scale · middle pan · right "
                                                                      "zoom · wheel slices · Shift crosshair"));
    m_keys->setToolTip(m_keys->text());
}

} // namespace ui
