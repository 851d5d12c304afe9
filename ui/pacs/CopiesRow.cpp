// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/CopiesRow.h"

#include "ui/base/Theme.h"
#include "ui/pacs/PacsCache.h"
#include "ui/widgets/fields/NumberField.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <functional>

namespace ui {

CopiesRow::CopiesRow(const core::DownloadCache& cache, QWidget* parent)
    : QWidget(parent)
    , m_cache(cache)
    , m_copies(new QLabel(this))
    , m_limit(new WholeNumberField(this))
    , m_clear(new QPushButton(tr("Clear"), this))
{
    m_copies->setObjectName(QStringLiteral("pacsCopies"));
    m_copies->setProperty("role", QStringLiteral("secondary"));
    m_limit->setObjectName(QStringLiteral("pacsLimit"));
    m_limit->setRange(1, 10000);
    m_limit->setSuffix(QStringLiteral(" GB"));
    m_limit->setValue(cacheGibibytes());
    m_limit->setToolTip(tr("How much room local copies may take; those used longest ago"
                           " go first, what is open stays"));
    m_clear->setObjectName(QStringLiteral("pacsClear"));
    m_clear->setAutoDefault(false);
    m_clear->hide();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_copies);
    layout->addWidget(m_limit);
    layout->addWidget(m_clear);
    connect(m_limit, &QSpinBox::valueChanged, this, [](int limit) { setCacheGibibytes(limit); });
    connect(m_clear, &QPushButton::clicked, this, &CopiesRow::clear);
}

void CopiesRow::count()
{
    m_job.start(
        [this, cache = m_cache](const core::Progress&) -> std::function<void()> {
            const qint64 bytes = cache.bytes();
            return [this, bytes] {
                m_copies->setText(bytes > 0
                        ? tr("Local copies: %1 of at most").arg(bytesText(bytes))
                        : tr("Local copies: none, at most"));
                m_clear->setVisible(bytes > 0);
            };
        },
        /* how many there are is not known, then: */ [](const core::Error&) {});
}

void CopiesRow::setClearable(bool clearable)
{
    m_clear->setEnabled(clearable);
}

void CopiesRow::clear()
{
    m_job.start(
        [this, cache = m_cache](const core::Progress&) -> std::function<void()> {
            const int removed = cache.clear();
            const bool someStay = cache.bytes() > 0;
            return [this, removed, someStay] {
                Q_EMIT cleared(removed, someStay);
                count();
            };
        },
        [this](const core::Error&) { Q_EMIT cleared(0, true); });
}

} // namespace ui
