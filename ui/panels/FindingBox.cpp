// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/FindingBox.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/texts/ProblemTexts.h"
#include "ui/texts/RepairTexts.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

/// More of them are a list to open.
constexpr std::size_t mostButtons = 4;

QLabel* wrapped(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

FindingBox::FindingBox(const core::SeriesFinding& finding, bool canChoose, QWidget* parent)
    : QFrame(parent)
    , m_finding(finding)
{
    // What was done on the command line may be more than one offer does.
    const QString& done = finding.problem.repairedBy;
    const auto& offers = finding.offers;
    const auto made = std::find_if(offers.begin(), offers.end(),
        [&](const core::RepairOffer& offer) { return offer.repair == done; });
    if (!done.isEmpty() && made == offers.end()) {
        m_finding.offers.push_back({.kind = core::RepairOffer::Kind::AsRepaired, .repair = done});
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    buildText(finding.problem);
    if (m_finding.offers.empty())
        return;
    buildChoices(canChoose);
    m_effect = wrapped(QString(), this);
    m_effect->setObjectName(QStringLiteral("repairEffect"));
    m_effect->setFont(theme::smallFont());
    m_effect->setProperty("role", QStringLiteral("secondary"));
    m_effect->setContentsMargins(24, 0, 0, 0);
    layout->addWidget(m_effect);
    for (std::size_t i = 0; i < m_finding.offers.size(); ++i) {
        if (!done.isEmpty() && m_finding.offers[i].repair == done)
            choose(int(i) + 1);
    }
    showEffect();
}

void FindingBox::buildText(const core::VolumeProblem& problem)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(theme::smallPadding);
    auto* icon = new QLabel(this);
    const bool repaired = !problem.repairedBy.isEmpty();
    const QColor colour = repaired ? theme::good
        : problem.caution          ? theme::caution
                                   : theme::secondary;
    icon->setPixmap(tintedIcon(repaired ? QStringLiteral("check") : QStringLiteral("caution"),
        colour, 16, devicePixelRatioF()));
    row->addWidget(icon, 0, Qt::AlignTop);
    auto* text = wrapped(problemText(problem.said), this);
    text->setObjectName(QStringLiteral("finding"));
    row->addWidget(text, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void FindingBox::buildChoices(bool canChoose)
{
    auto* choices = new QVBoxLayout;
    choices->setContentsMargins(24, 0, 0, 0);
    choices->setSpacing(0);
    QStringList names{tr("As it is")};
    for (const core::RepairOffer& offer : m_finding.offers)
        names += repairTitle(offer);
    if (m_finding.offers.size() > mostButtons) {
        m_list = new QComboBox(this);
        m_list->setObjectName(QStringLiteral("repairChoice"));
        m_list->addItems(names);
        m_list->setFixedHeight(theme::controlHeight);
        m_list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        m_list->setEnabled(canChoose);
        choices->addWidget(m_list);
        connect(m_list, &QComboBox::currentIndexChanged, this, &FindingBox::choose);
    } else {
        m_buttons = new QButtonGroup(this);
        for (qsizetype choice = 0; choice < names.size(); ++choice) {
            auto* button = new QRadioButton(names[choice], this);
            button->setObjectName(QStringLiteral("repairChoice%1").arg(choice));
            button->setMinimumHeight(theme::controlHeight);
            button->setEnabled(canChoose);
            m_buttons->addButton(button, int(choice));
            choices->addWidget(button);
        }
        m_buttons->button(0)->setChecked(true);
        connect(m_buttons, &QButtonGroup::idClicked, this, &FindingBox::choose);
    }
    static_cast<QVBoxLayout*>(layout())->addLayout(choices);
}

const core::RepairOffer* FindingBox::chosen() const
{
    return m_choice == 0 ? nullptr : &m_finding.offers[std::size_t(m_choice - 1)];
}

void FindingBox::choose(int choice)
{
    if (m_buttons != nullptr)
        m_buttons->button(choice)->setChecked(true);
    if (m_list != nullptr) {
        const QSignalBlocker blocker(m_list);
        m_list->setCurrentIndex(choice);
    }
    if (choice == m_choice)
        return;
    m_choice = choice;
    showEffect();
    Q_EMIT chosenChanged();
}

void FindingBox::showEffect()
{
    if (m_effect == nullptr)
        return;
    const core::RepairOffer* offer = chosen();
    m_effect->setText(offer != nullptr ? repairEffect(*offer) : QString());
    m_effect->setVisible(!m_effect->text().isEmpty());
}

} // namespace ui
