// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/DeidentifyBox.h"

#include "ui/base/Theme.h"
#include "ui/widgets/fields/NumberField.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QSpinBox>
#include <QUuid>
#include <QVBoxLayout>

#include <initializer_list>

namespace ui {

namespace {

QString key(const char* name)
{
    return QStringLiteral("deidentify/") + QLatin1String(name);
}

/// Drawn once for this user.
QByteArray keptSecret()
{
    QSettings settings;
    QByteArray secret = QByteArray::fromHex(settings.value(key("secret")).toByteArray());
    if (secret.size() < 32) {
        secret = QUuid::createUuid().toRfc4122() + QUuid::createUuid().toRfc4122();
        settings.setValue(key("secret"), secret.toHex());
    }
    return secret;
}

} // namespace

DeidentifyBox::DeidentifyBox(QWidget* parent)
    : QWidget(parent)
    , m_wanted(new QCheckBox(tr("Take the patient out (de-identify)"), this))
    , m_details(new QWidget(this))
    , m_dates(new QComboBox(this))
    , m_days(new WholeNumberField(this))
    , m_device(new QCheckBox(tr("Keep the scanner"), this))
    , m_descriptions(new QCheckBox(tr("Keep names and descriptions, cleaned"), this))
    , m_linked(new QCheckBox(tr("Same new numbers as in my earlier exports"), this))
{
    m_wanted->setObjectName(QStringLiteral("deidentify"));
    m_dates->setObjectName(QStringLiteral("deidentifyDates"));
    m_dates->addItem(tr("Dates removed"), int(core::DeidentifyOptions::Dates::Remove));
    m_dates->addItem(tr("Dates shifted by"), int(core::DeidentifyOptions::Dates::Shift));
    m_dates->addItem(tr("Dates kept"), int(core::DeidentifyOptions::Dates::Keep));
    m_days->setObjectName(QStringLiteral("deidentifyDays"));
    m_days->setRange(-36500, 36500);
    m_days->setSuffix(tr(" days"));
    m_device->setToolTip(tr("Maker, model and serial number of the scanner"));
    m_descriptions->setToolTip(
        tr("Names of segments and descriptions of study and series stay, without the words of the "
           "patient's name and numbers; otherwise segments are named by their codes"));
    m_linked->setObjectName(QStringLiteral("deidentifyLinked"));
    m_linked->setToolTip(tr(
        "The same study gets the same new UIDs and the same patient number each time, made under "
        "a secret that is kept in your settings; otherwise a new secret is drawn and forgotten"));

    const QSettings settings;
    m_dates->setCurrentIndex(settings.value(key("dates"), 0).toInt());
    m_days->setValue(settings.value(key("days"), -100).toInt());
    m_device->setChecked(settings.value(key("device"), false).toBool());
    m_descriptions->setChecked(settings.value(key("descriptions"), false).toBool());
    m_linked->setChecked(settings.value(key("linked"), true).toBool());

    auto* dates = new QHBoxLayout;
    dates->setContentsMargins(0, 0, 0, 0);
    dates->addWidget(m_dates);
    dates->addWidget(m_days);
    dates->addSpacing(theme::padding);
    dates->addWidget(m_device);
    dates->addSpacing(theme::padding);
    dates->addWidget(m_linked);
    dates->addStretch(1);
    auto* details = new QVBoxLayout(m_details);
    details->setContentsMargins(22, 0, 0, 0);
    details->setSpacing(theme::smallPadding);
    details->addLayout(dates);
    details->addWidget(m_descriptions);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_wanted);
    layout->addWidget(m_details);

    connect(m_wanted, &QCheckBox::toggled, this, &DeidentifyBox::showChoice);
    connect(m_dates, &QComboBox::currentIndexChanged, this, &DeidentifyBox::showChoice);
    connect(m_dates, &QComboBox::currentIndexChanged, this, &DeidentifyBox::changed);
    connect(m_days, &QSpinBox::valueChanged, this, &DeidentifyBox::changed);
    for (const QCheckBox* each : {m_wanted, m_device, m_descriptions, m_linked})
        connect(each, &QCheckBox::toggled, this, &DeidentifyBox::changed);
    showChoice();
}

void DeidentifyBox::askForSession()
{
    m_wanted->setChecked(true);
    m_descriptions->setText(tr("Keep the description of the series, cleaned"));
    m_descriptions->setToolTip(tr("Without the words of the patient's name and numbers"));
    for (QWidget* other : std::initializer_list<QWidget*>{m_wanted, m_device, m_linked})
        other->hide();
    m_details->layout()->setContentsMargins(0, 0, 0, 0);
}

std::shared_ptr<const core::Deidentifier> DeidentifyBox::deidentifier(
    const core::StudyIdentity& patient) const
{
    if (!m_wanted->isChecked())
        return {};
    QSettings settings;
    settings.setValue(key("dates"), m_dates->currentIndex());
    settings.setValue(key("days"), m_days->value());
    settings.setValue(key("device"), m_device->isChecked());
    settings.setValue(key("descriptions"), m_descriptions->isChecked());
    settings.setValue(key("linked"), m_linked->isChecked());
    const core::DeidentifyOptions options{
        .dates = core::DeidentifyOptions::Dates(m_dates->currentData().toInt()),
        .shiftDays = m_days->value(),
        .keepDevice = m_device->isChecked(),
        .keepDescriptions = m_descriptions->isChecked()};
    return std::make_shared<core::Deidentifier>(
        options, patient, m_linked->isChecked() ? keptSecret() : QByteArray());
}

QString DeidentifyBox::problem() const
{
    const bool shiftsByNone = m_wanted->isChecked() && m_days->value() == 0
        && m_dates->currentData().toInt() == int(core::DeidentifyOptions::Dates::Shift);
    return shiftsByNone ? tr("Dates are shifted by whole days, not by none.") : QString();
}

void DeidentifyBox::showChoice()
{
    m_details->setVisible(m_wanted->isChecked());
    m_days->setVisible(
        m_dates->currentData().toInt() == int(core::DeidentifyOptions::Dates::Shift));
}

} // namespace ui
