// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/history/KeyframePopup.h"

#include "ui/base/Theme.h"
#include "ui/settings/KeyframeRule.h"

#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

KeyframePopup::KeyframePopup(QWidget* parent)
    : QFrame(parent, Qt::ToolTip | Qt::FramelessWindowHint | Qt::WindowTransparentForInput)
    , m_picture(new QLabel(this))
    , m_step(new QLabel(this))
    , m_note(new QLabel(this))
{
    setObjectName(QStringLiteral("keyframePopup"));
    setAttribute(Qt::WA_ShowWithoutActivating);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFrameShape(QFrame::NoFrame);
    setStyleSheet(QStringLiteral("#keyframePopup { background: %1; border: 1px solid %2; }")
                      .arg(theme::raised.name(), theme::line.name()));
    constexpr int border = 1;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(border, border, border, border + theme::smallPadding);
    layout->setSpacing(2);
    m_picture->setAlignment(Qt::AlignCenter);
    m_picture->setStyleSheet(QStringLiteral("background: %1").arg(theme::picture.name()));
    m_picture->setFixedWidth(KeyframeRule::pictureSize.width());
    layout->addWidget(m_picture);
    layout->addSpacing(theme::smallPadding - 2);
    for (QLabel* label : {m_step, m_note}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        label->setFixedWidth(KeyframeRule::pictureSize.width());
        label->setContentsMargins(theme::smallPadding, 0, theme::smallPadding, 0);
        layout->addWidget(label);
    }
    m_note->setFont(theme::smallFont());
    m_note->setProperty("role", QStringLiteral("secondary"));
}

void KeyframePopup::show(const QString& step, const QString& note, const QImage& picture)
{
    m_shown = picture;
    m_picture->setVisible(!picture.isNull());
    m_picture->setPixmap(QPixmap::fromImage(picture));
    m_picture->setFixedHeight(std::max(picture.height(), 1));
    m_step->setText(step);
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
    layout()->activate();
    adjustSize();
    QFrame::show();
}

QString KeyframePopup::words() const
{
    return m_note->text().isEmpty() ? m_step->text() : m_step->text() + u'\n' + m_note->text();
}

void KeyframePopup::moveAbove(const QPoint& global)
{
    const QRect room = parentWidget()->screen()->availableGeometry();
    const int x = std::clamp(
        global.x() - width() / 2, room.left(), std::max(room.left(), room.right() + 1 - width()));
    const int y = std::max(room.top(), global.y() - height() - theme::smallPadding);
    move(x, y);
}

} // namespace ui
