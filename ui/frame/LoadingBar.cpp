// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/LoadingBar.h"

#include "ui/base/Theme.h"
#include "ui/settings/StudyOpener.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace ui {

LoadingBar::LoadingBar(QWidget* parent)
    : QFrame(parent)
    , m_what(new QLabel(this))
    , m_step(new QLabel(this))
    , m_bar(new QProgressBar(this))
{
    setProperty("role", QStringLiteral("bar"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(theme::padding, 6, 6, 6);
    layout->setSpacing(theme::padding);
    m_what->setFont(theme::headingFont());
    m_step->setProperty("role", QStringLiteral("secondary"));
    m_step->setMinimumWidth(280);
    m_bar->setTextVisible(false);
    m_bar->setFixedHeight(6);
    auto* abort = new QPushButton(tr("Abort"), this);
    layout->addWidget(m_what);
    layout->addWidget(m_step);
    layout->addWidget(m_bar, 1);
    layout->addWidget(abort);
    connect(abort, &QPushButton::clicked, this, &LoadingBar::aborted);
    m_later.setSingleShot(true);
    connect(&m_later, &QTimer::timeout, this, &LoadingBar::show);
    end();
}

void LoadingBar::follow(StudyOpener& opener)
{
    connect(&opener, &StudyOpener::started, this,
        [this](const QString& path) { begin(tr("Opening %1").arg(QFileInfo(path).fileName())); });
    connect(&opener, &StudyOpener::progressed, this, &LoadingBar::progress);
    connect(&opener, &StudyOpener::finished, this, [this, &opener] {
        if (!opener.busy())
            end();
    });
    connect(this, &LoadingBar::aborted, &opener, &StudyOpener::cancel);
}

void LoadingBar::begin(const QString& what)
{
    m_what->setText(what);
    m_step->clear();
    m_stepName.clear();
    m_bar->setRange(0, 0);
    if (m_later.interval() == 0)
        show();
    else
        m_later.start();
}

void LoadingBar::progress(const QString& step, int done, int total)
{
    if (step != m_stepName) {
        m_stepName = step;
        m_clock.start();
    }
    m_bar->setRange(0, total);
    m_bar->setValue(done);
    QString text = step;
    if (total > 0) {
        text += tr(" · %1 of %2").arg(done).arg(total);
        const double elapsed = double(m_clock.elapsed()) / 1000.0;
        // A first guess only once there is something to guess from.
        if (done > 0 && elapsed > 1.0 && done < total) {
            const double left = elapsed * (total - done) / done;
            text += tr(" · about %1 s left").arg(int(left) + 1);
        }
    }
    m_step->setText(text);
}

void LoadingBar::percent(int done)
{
    m_bar->setRange(0, 100);
    m_bar->setValue(done);
    m_step->setText(tr("%1 %").arg(done));
}

void LoadingBar::end()
{
    m_later.stop();
    hide();
}

} // namespace ui
