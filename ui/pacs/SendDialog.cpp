// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/SendDialog.h"

#include "ui/base/ErrorText.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/pacs/SourcesDialog.h"
#include "ui/settings/PacsSources.h"
#include "ui/widgets/StateLine.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

const QString lastTargetKey = QStringLiteral("pacs/lastTarget");

} // namespace

SendDialog::SendDialog(const QStringList& files, QWidget* parent)
    : QDialog(parent)
    , m_files(files)
    , m_source(new QComboBox(this))
    , m_state(new StateLine(QStringLiteral("sendState"), this))
    , m_progress(new QProgressBar(this))
    , m_edit(new QPushButton(tr("Sources …"), this))
    , m_send(new QPushButton(tr("Send"), this))
    , m_close(new QPushButton(tr("Close"), this))
{
    setWindowTitle(tr("Send to PACS"));
    resize(560, 200);
    m_source->setObjectName(QStringLiteral("sendSource"));
    m_send->setObjectName(QStringLiteral("sendStart"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_progress->hide();
    m_send->setDefault(true);
    for (QPushButton* button : {m_edit, m_close})
        button->setAutoDefault(false);
    auto* what = new QLabel(this);
    what->setProperty("role", QStringLiteral("heading"));
    what->setTextFormat(Qt::PlainText);
    what->setWordWrap(true);
    what->setText(
        files.size() == 1 ? QFileInfo(files.front()).fileName() : tr("%1 files").arg(files.size()));
    auto* to = new QHBoxLayout;
    to->setSpacing(theme::smallPadding);
    to->addWidget(new QLabel(tr("To"), this));
    to->addWidget(m_source, 1);
    to->addWidget(m_edit);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_close);
    buttons->addWidget(m_send);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(12);
    layout->addWidget(what);
    layout->addLayout(to);
    layout->addWidget(m_state);
    layout->addWidget(m_progress);
    layout->addStretch(1);
    layout->addLayout(buttons);
    tabAsLaidOut(*this);
    connect(m_send, &QPushButton::clicked, this, &SendDialog::send);
    connect(m_close, &QPushButton::clicked, this, &SendDialog::reject);
    connect(m_edit, &QPushButton::clicked, this, [this] {
        if (SourcesDialog(this).exec() == QDialog::Accepted)
            fillSources();
    });
    connect(&m_job, &BackgroundJob::progressed, this, [this](const QString&, int done, int total) {
        m_progress->setRange(0, total);
        m_progress->setValue(done);
        if (total > 1 && done > 0)
            m_state->say(tr("Sending · %1 of %2 files").arg(done).arg(total));
    });
    connect(&m_job, &BackgroundJob::ended, this, [this] { showRunning(false); });
    fillSources();
}

void SendDialog::fillSources()
{
    m_sources = pacsSources();
    m_source->clear();
    for (const core::PacsSource& one : m_sources)
        m_source->addItem(QStringLiteral("%1  ·  %2").arg(one.name, one.address()), one.name);
    m_source->setCurrentIndex(
        std::max(0, m_source->findData(QSettings().value(lastTargetKey).toString())));
    m_send->setEnabled(!m_sources.empty());
    m_state->say(m_sources.empty() ? tr("There is no source yet: add one by Sources …")
                                   : QString());
}

void SendDialog::send()
{
    const int row = m_source->currentIndex();
    if (row < 0 || m_job.running())
        return;
    const core::PacsSource source = m_sources[std::size_t(row)];
    QSettings().setValue(lastTargetKey, source.name);
    m_state->say(tr("Sending to %1 …").arg(source.address()));
    m_progress->setRange(0, 0);
    m_job.start(
        [this, source, files = m_files](const core::Progress& progress) -> std::function<void()> {
            const core::Result<core::SentObjects> sent = core::sendFiles(source, files, progress);
            return [this, source, sent] {
                if (!sent)
                    return m_state->say(errorText(sent.error()), "bad");
                m_close->setDefault(true); // it is done: Enter is not to send it again
                QStringList lines{sent->sent == 1
                        ? tr("✓ %1 took it.").arg(source.address())
                        : tr("✓ %1 took %2 files.").arg(source.address()).arg(sent->sent)};
                lines += sent->warnings;
                m_state->say(lines.join(u'\n'), sent->warnings.isEmpty() ? "good" : "caution");
            };
        },
        [this](const core::Error& error) { m_state->say(errorText(error), "bad"); });
    showRunning(true);
}

void SendDialog::showRunning(bool running)
{
    m_progress->setVisible(running);
    m_source->setEnabled(!running);
    m_edit->setEnabled(!running);
    m_send->setEnabled(!running && !m_sources.empty());
    m_close->setText(running ? tr("Abort") : tr("Close"));
}

void SendDialog::reject()
{
    if (!m_job.running())
        return QDialog::reject();
    m_job.cancel();
    m_state->say(tr("Aborted; what was sent before stays there."));
}

} // namespace ui
