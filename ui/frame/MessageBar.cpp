// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/MessageBar.h"

#include "core/session/EditSession.h"
#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace ui {

namespace {

QColor colourOf(MessageBar::Kind kind)
{
    switch (kind) {
    case MessageBar::Kind::Notice:
        return theme::accent;
    case MessageBar::Kind::Caution:
        return theme::caution;
    case MessageBar::Kind::Error:
        break;
    }
    return theme::bad;
}

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent)
    , m_icon(new QLabel(this))
    , m_text(new QLabel(this))
    , m_button(new QPushButton(this))
    , m_close(new QToolButton(this))
{
    setObjectName(QStringLiteral("messageBar"));
    setAttribute(Qt::WA_StyledBackground);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(theme::padding, 6, 6, 6);
    layout->setSpacing(theme::smallPadding);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setIcon(stateIcon(QStringLiteral("close")));
    m_close->setIconSize(QSize(16, 16));
    m_close->setObjectName(QStringLiteral("closeMessage"));
    m_close->setAccessibleName(tr("Close this message"));
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_button);
    layout->addWidget(m_close);
    connect(m_close, &QToolButton::clicked, this, &MessageBar::dismiss);
    connect(m_button, &QPushButton::clicked, this, [this] {
        const auto run = m_run;
        dismiss();
        if (run)
            run();
    });
    m_leaving.setSingleShot(true);
    m_leaving.setInterval(noticeMs);
    connect(&m_leaving, &QTimer::timeout, this, [this] {
        // Who reads it, or marks it to copy it, is not interrupted.
        if (underMouse())
            m_leaving.start();
        else
            dismiss();
    });
    dismiss();
}

void MessageBar::show(Kind kind, const QString& sentence)
{
    show(kind, sentence, QString(), {});
}

void MessageBar::show(
    Kind kind, const QString& sentence, const QString& button, std::function<void()> run)
{
    const QColor colour = colourOf(kind);
    setStyleSheet(QStringLiteral("#messageBar { background: %1; border-left: 3px solid %2; }")
                      .arg(theme::raised.name(), colour.name()));
    m_icon->setPixmap(
        tintedIcon(kind == Kind::Notice ? QStringLiteral("check") : QStringLiteral("caution"),
            colour, 18, devicePixelRatioF()));
    m_text->setText(sentence);
    m_button->setText(button);
    m_button->setVisible(!button.isEmpty());
    // As high without a button, lest what is below move when one comes.
    m_button->ensurePolished();
    m_text->setMinimumHeight(m_button->sizeHint().height());
    m_run = std::move(run);
    setTips(QString(), tr("Close this message; nothing else changes"));
    setVisible(true);
    if (kind == Kind::Notice && button.isEmpty())
        m_leaving.start();
    else
        m_leaving.stop();
}

void MessageBar::setTips(const QString& button, const QString& close)
{
    m_button->setToolTip(button);
    m_close->setToolTip(close);
}

void MessageBar::dismissAtNextStep(Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return;
    auto* waiting = new QObject(this);
    connect(&workspace, &Workspace::documentChanged, waiting,
        [this, &workspace, waiting, said = sentence(), position = session->history().position()] {
            if (sentence() == said) {
                const core::EditSession* now = workspace.session();
                if (now && now->history().position() == position)
                    return;
                dismiss();
            }
            waiting->deleteLater();
        });
}

void MessageBar::dismiss()
{
    m_leaving.stop();
    m_run = {};
    setVisible(false);
    m_text->clear();
}

QString MessageBar::sentence() const
{
    return m_text->text();
}

} // namespace ui
