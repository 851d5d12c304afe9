// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/ExportRun.h"

#include "ui/base/ErrorText.h"
#include "ui/base/Theme.h"
#include "ui/widgets/StateLine.h"

#include <QDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

QString paragraph(const QString& text, const QColor& colour, const QString& before = {})
{
    return QStringLiteral("<p style=\"margin: 0 0 3px 0; color: %1\">%2%3</p>")
        .arg(colour.name(), before, text.toHtmlEscaped());
}

QString inColour(const QString& sign, const QColor& colour)
{
    return QStringLiteral("<span style=\"color: %1\">%2</span> ").arg(colour.name(), sign);
}

} // namespace

ExportRun::ExportRun(const QString& name, QPushButton* start, QDialog* dialog)
    : QWidget(dialog)
    , m_start(start)
    , m_close(new QPushButton(tr("Close"), dialog))
    , m_state(new StateLine(name + QStringLiteral("State"), this))
    , m_progress(new QProgressBar(this))
    , m_report(new QLabel)
    , m_scroll(new QScrollArea(this))
{
    m_start->setDefault(true);
    m_close->setAutoDefault(false);
    connect(m_start, &QPushButton::clicked, this, &ExportRun::startRequested);
    connect(m_close, &QPushButton::clicked, this, &ExportRun::closeRequested);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_progress->hide();
    m_report->setObjectName(name + QStringLiteral("Report"));
    m_report->setTextFormat(Qt::RichText);
    m_report->setWordWrap(true);
    m_report->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_report->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_scroll->setWidget(m_report);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->viewport()->setAutoFillBackground(false);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_state);
    layout->addWidget(m_progress);
    layout->addWidget(m_scroll);
    say({});
}

QHBoxLayout* ExportRun::makeButtons(QPushButton* other)
{
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_close);
    if (other)
        row->addWidget(other);
    row->addWidget(m_start);
    return row;
}

void ExportRun::say(const QString& sentence, const char* role)
{
    m_state->say(sentence, role);
    m_state->setVisible(!sentence.isEmpty());
}

void ExportRun::sayMissing(const QString& sentence)
{
    say(sentence);
    m_start->setEnabled(sentence.isEmpty());
}

void ExportRun::setBusy(bool busy)
{
    m_progress->setVisible(busy);
}

void ExportRun::setRunning(bool running)
{
    setBusy(running);
    m_close->setText(running ? tr("Abort") : tr("Close"));
    if (running)
        m_start->setEnabled(false);
}

void ExportRun::showProgress(const QString& step, int done, int total)
{
    m_progress->setRange(0, std::max(total, 0));
    m_progress->setValue(done);
    say(step);
}

void ExportRun::showReport(const WordedReport& report)
{
    QString text = QStringLiteral("<p style=\"margin: 0 0 3px 0; color: %1\"><b>%2</b></p>")
                       .arg(theme::good.name(),
                           tr("%1 is written, and was read again and checked.")
                               .arg(QFileInfo(report.file).fileName())
                               .toHtmlEscaped());
    for (const QString& sentence : report.written)
        text += paragraph(sentence, theme::text);
    for (const QString& sentence : report.checked)
        text += paragraph(sentence, theme::text, inColour(QStringLiteral("✓"), theme::good));
    for (const QString& caution : report.cautions)
        text += paragraph(tr("Caution: %1").arg(caution), theme::caution);
    if (!report.sha256.isEmpty())
        text += paragraph(tr("SHA-256: %1").arg(report.sha256), theme::secondary);
    m_report->setText(text);
    m_scroll->show();
    say({});
    growDialog();
    m_close->setDefault(true); // it is done: Enter is not to replace it
}

void ExportRun::clearReport()
{
    m_scroll->hide();
    m_report->clear();
}

void ExportRun::expectStart()
{
    clearReport();
    m_start->setDefault(true);
}

void ExportRun::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitReport();
}

/// As high as its lines, as far as that goes.
void ExportRun::fitReport()
{
    constexpr int mostHeight = 240;
    m_report->ensurePolished(); // or it would be measured in another font before it is first shown
    m_scroll->setFixedHeight(std::clamp(m_report->heightForWidth(width()), 0, mostHeight));
}

/// A verdict is seen whole without anybody drawing the dialog larger; no more than the screen has.
void ExportRun::growDialog()
{
    fitReport();
    QWidget* dialog = window();
    if (!dialog->layout())
        return;
    // What it needs is known to the dialog's layout only when events have gone up from here.
    layout()->activate();
    for (QWidget* part = this; part != dialog; part = part->parentWidget())
        part->updateGeometry();
    dialog->layout()->activate();
    const int frame = dialog->frameGeometry().height() - dialog->height();
    const int most = dialog->screen()->availableGeometry().height() - frame;
    const int needed = dialog->layout()->totalMinimumHeightForWidth(dialog->width());
    dialog->resize(
        dialog->width(), std::clamp(needed, dialog->height(), std::max(most, dialog->height())));
}

void ExportRun::showFailure(const core::Error& error)
{
    if (error.code == core::ErrorCode::Cancelled)
        say(tr("The export was aborted; nothing was written."));
    else
        say(errorText(error), "bad");
}

bool mayReplace(const QString& file, QWidget* parent)
{
    QMessageBox box(QMessageBox::Question, ExportRun::tr("Replace the file?"),
        ExportRun::tr("%1 exists already. Replace it?").arg(file),
        QMessageBox::Yes | QMessageBox::No, parent);
    box.button(QMessageBox::Yes)->setText(ExportRun::tr("Replace"));
    box.button(QMessageBox::No)->setText(ExportRun::tr("Keep it"));
    box.setDefaultButton(QMessageBox::No);
    return box.exec() == QMessageBox::Yes;
}

} // namespace ui
