// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/SeriesDoctorPanel.h"

#include "core/repair/RepairLattice.h"
#include "core/session/EditSession.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/panels/FindingBox.h"
#include "ui/panels/TimeSlider.h"
#include "ui/workspace/Workspace.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <optional>

namespace ui {

namespace {

QString gridText(const core::VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    // Three lines: side by side with another in the width of a panel one would be cut off.
    return QObject::tr("%1 × %2 × %3\n%4 × %5 mm\n%6")
        .arg(geometry.size.x)
        .arg(geometry.size.y)
        .arg(geometry.size.z)
        .arg(QString::number(spacing.x, 'g', 3), QString::number(spacing.y, 'g', 3),
            slicesApartText(geometry));
}

QLabel* smallText(QWidget* parent, const QString& text = {})
{
    auto* label = new QLabel(text, parent);
    label->setFont(theme::smallFont());
    label->setProperty("role", QStringLiteral("secondary"));
    return label;
}

} // namespace

SeriesDoctorPanel::SeriesDoctorPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
{
    build();
    connect(m_apply, &QPushButton::clicked, this, &SeriesDoctorPanel::apply);
    connect(&workspace, &Workspace::sessionChanged, this, &SeriesDoctorPanel::showVolume);
    connect(&workspace, &Workspace::cautionAcceptedChanged, this, &SeriesDoctorPanel::showChoice);
    showVolume();
}

void SeriesDoctorPanel::build()
{
    m_list = new QVBoxLayout;
    m_list->setSpacing(theme::padding);

    m_decision = new QWidget(this);
    auto* grids = new QGridLayout;
    grids->setHorizontalSpacing(theme::smallPadding);
    grids->setColumnStretch(0, 1);
    grids->setColumnStretch(1, 1);
    grids->addWidget(smallText(m_decision, tr("Now")), 0, 0);
    grids->addWidget(smallText(m_decision, tr("Then")), 0, 1);
    m_now = new QLabel(m_decision);
    m_now->setObjectName(QStringLiteral("gridNow"));
    m_after = new QLabel(m_decision);
    m_after->setObjectName(QStringLiteral("gridAfter"));
    grids->addWidget(m_now, 1, 0, Qt::AlignTop);
    grids->addWidget(m_after, 1, 1, Qt::AlignTop);
    m_note = smallText(m_decision);
    m_note->setWordWrap(true);
    m_apply = new QPushButton(m_decision);
    m_apply->setObjectName(QStringLiteral("applyRepair"));
    m_apply->setProperty("role", QStringLiteral("primary"));
    auto* decision = new QVBoxLayout(m_decision);
    decision->setContentsMargins(0, 0, 0, 0);
    decision->setSpacing(theme::smallPadding);
    decision->addLayout(grids);
    decision->addWidget(m_note);
    decision->addWidget(m_apply);

    m_times = new TimeSlider(m_workspace, this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::smallPadding, theme::padding, theme::padding);
    layout->setSpacing(theme::padding);
    layout->addLayout(m_list);
    layout->addWidget(m_decision);
    layout->addWidget(m_times);
}

QString SeriesDoctorPanel::title() const
{
    return tr("Series doctor");
}

QString SeriesDoctorPanel::summary() const
{
    const core::Volume* volume = m_workspace.volume();
    if (volume == nullptr)
        return {};
    if (!volume->repair.isEmpty())
        return tr("repaired");
    return m_boxes.size() == 1 ? tr("1 finding") : tr("%1 findings").arg(m_boxes.size());
}

bool SeriesDoctorPanel::hasSomething() const
{
    return !m_boxes.empty();
}

void SeriesDoctorPanel::showVolume()
{
    qDeleteAll(m_boxes);
    m_boxes.clear();
    const core::Volume* volume = m_workspace.volume();
    bool anyOffer = false;
    if (volume != nullptr) {
        for (const core::SeriesFinding& finding : core::seriesFindings(*volume)) {
            anyOffer = anyOffer || !finding.offers.empty() || finding.problem.caution;
            auto* box = new FindingBox(finding, volume->alternatives != nullptr, this);
            m_boxes.push_back(box);
            m_list->addWidget(box);
            connect(box, &FindingBox::chosenChanged, this, &SeriesDoctorPanel::showChoice);
        }
    }
    m_decision->setVisible(anyOffer);
    m_times->showVolume();
    showChoice();
    Q_EMIT summaryChanged(summary());
    Q_EMIT hasSomethingChanged();
    if (volume != nullptr && volume->needsCaution())
        Q_EMIT unfoldRequested();
}

const core::RepairOffer* SeriesDoctorPanel::otherStack() const
{
    for (const FindingBox* box : m_boxes) {
        if (const core::RepairOffer* offer = box->chosen(); offer && !offer->series.isEmpty())
            return offer;
    }
    return nullptr;
}

QString SeriesDoctorPanel::chosenRepair() const
{
    QStringList words;
    for (const FindingBox* box : m_boxes) {
        if (const core::RepairOffer* offer = box->chosen(); offer && !offer->repair.isEmpty())
            words += offer->repair;
    }
    const auto repair = core::SeriesRepair::fromText(words.join(u','));
    return repair ? repair->toText() : QString();
}

void SeriesDoctorPanel::showChoice()
{
    const core::Volume* volume = m_workspace.volume();
    if (volume == nullptr)
        return;
    const QString chosen = chosenRepair();
    const core::RepairOffer* stack = otherStack();
    const bool changes = stack != nullptr || chosen != volume->repair;
    m_now->setText(gridText(volume->geometry));
    std::optional<core::VolumeGeometry> after;
    if (stack != nullptr) {
        after = stack->result;
    } else if (changes) {
        const core::SeriesRepair repair =
            core::SeriesRepair::fromText(chosen).value_or(core::SeriesRepair());
        core::VolumeGeometry slices = volume->asIs ? volume->asIs->geometry : volume->geometry;
        if (repair.duplicates != core::SeriesRepair::Duplicates::Keep && volume->alternatives)
            slices = volume->alternatives->undoubled.value_or(slices);
        if (core::repairObstacle(slices, repair).isEmpty())
            after = core::repairedGeometry(slices, repair);
    }
    m_after->setText(after ? gridText(*after) : tr("the same"));

    const bool drawnOn =
        m_workspace.session() != nullptr && !m_workspace.session()->history().rows().empty();
    const bool atHand = volume->alternatives != nullptr;
    QString note;
    if (!atHand)
        note = tr("The study's files are not at hand; only they can be opened otherwise.");
    else if (changes && drawnOn)
        note = tr("Opens the study anew. What was drawn stays in its own session, on the series as "
                  "it is now.");
    else if (changes)
        note = tr("Opens the study anew; its files stay as they are.");
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
    const bool accept = !changes && volume->needsCaution() && !m_workspace.cautionAccepted();
    const bool unrepaired = chosen.isEmpty() && changes && stack == nullptr;
    m_apply->setText(accept ? tr("Keep as it is") : unrepaired ? tr("Open as it is") : tr("Apply"));
    m_apply->setEnabled(accept || (changes && atHand));
    QString tip;
    if (accept)
        tip = tr("Takes the caution out of the views: nothing of the series changes, and exports "
                 "still tell it");
    else if (!changes)
        tip = tr("Choose something else above first");
    else if (stack != nullptr)
        tip = tr("Opens the other images");
    else if (unrepaired)
        tip = tr("Opens the study again without repairs");
    else
        tip = tr("Opens the study again with the repairs that are chosen");
    m_apply->setToolTip(tip);
}

void SeriesDoctorPanel::apply()
{
    const core::Volume* volume = m_workspace.volume();
    if (volume == nullptr)
        return;
    if (const core::RepairOffer* stack = otherStack())
        Q_EMIT reopenRequested(volume->sourcePath, stack->series);
    else if (const QString chosen = chosenRepair(); chosen != volume->repair)
        Q_EMIT reopenRequested(volume->sourcePath, core::withRepair(volume->seriesKey, chosen));
    else
        m_workspace.acceptCaution();
}

} // namespace ui
