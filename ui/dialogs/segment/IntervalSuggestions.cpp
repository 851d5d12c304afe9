// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/IntervalSuggestions.h"

#include "core/growth/ProbedVoxel.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/OtsuThresholds.h"
#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPointer>
#include <QToolButton>

#include <algorithm>
#include <limits>

namespace ui {

namespace {

/// Usual intervals of a CT, HU.
struct Tissue {
    QString name;
    double lower;
    double upper;
};

std::vector<Tissue> tissuesOfCt()
{
    constexpr double far = std::numeric_limits<double>::infinity();
    return {{IntervalSuggestions::tr("Bone"), 226.0, far},
        {IntervalSuggestions::tr("Soft tissue"), -160.0, 225.0},
        {IntervalSuggestions::tr("Lung"), -950.0, -500.0},
        {IntervalSuggestions::tr("Air"), -far, -951.0}};
}

QString intervalText(const std::pair<double, double>& interval, const QString& unit)
{
    const QString text = IntervalSuggestions::tr("%1 … %2").arg(
        digitsText(interval.first, 5), digitsText(interval.second, 5));
    return unit.isEmpty() ? text : text + QLatin1Char(' ') + unit;
}

QToolButton* lowButton(const char* name, const QString& text, const QString& tip, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    button->setToolTip(tip);
    button->setFixedHeight(theme::controlHeight);
    return button;
}

} // namespace

IntervalSuggestions::IntervalSuggestions(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
{
    auto* otsu = lowButton("thresholdOtsu", tr("Otsu"),
        tr("From the value on that parts the histogram into two"), this);
    connect(otsu, &QToolButton::clicked, this, [this] {
        if (const std::vector<Interval> two = parts(1); !two.empty())
            suggest(two.back());
    });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme::smallPadding);
    row->addWidget(otsu);
    row->addWidget(menuButton("thresholdThree", tr("3 parts"),
        tr("One of three parts of the histogram (Otsu)"),
        [this](QMenu& menu) { offerParts(menu, 2); }));
    row->addWidget(
        menuButton("thresholdFour", tr("4 parts"), tr("One of four parts of the histogram (Otsu)"),
            [this](QMenu& menu) { offerParts(menu, 3); }));
    m_tissues = menuButton("thresholdTissues", tr("CT"), tr("Usual intervals of a CT"),
        [this](QMenu& menu) { offerTissues(menu); });
    row->addWidget(m_tissues);
    row->addStretch(1);
    m_pick = lowButton("thresholdPick", tr("Pick"),
        tr("Click on slices: the interval becomes the values there and beside it, and each further "
           "click widens it"),
        this);
    m_pick->setCheckable(true);
    row->addWidget(m_pick);
    connect(m_pick, &QToolButton::toggled, this, &IntervalSuggestions::pick);
    connect(&workspace, &Workspace::crosshairChanged, this, &IntervalSuggestions::pickAtCrosshair);
    const auto suit = [this] { m_tissues->setVisible(isCt()); };
    connect(&workspace, &Workspace::sessionChanged, this, suit);
    suit();
}

QToolButton* IntervalSuggestions::menuButton(const char* name, const QString& text,
    const QString& tip, const std::function<void(QMenu&)>& fill)
{
    QToolButton* button = lowButton(name, text, tip, this);
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    button->setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, [menu, fill] {
        menu->clear();
        fill(*menu);
    });
    return button;
}

bool IntervalSuggestions::isCt() const
{
    const core::Volume* volume = m_workspace.volume();
    return volume && volume->unit == QLatin1String("HU");
}

IntervalSuggestions::Interval IntervalSuggestions::first() const
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return {};
    if (const double bone = tissuesOfCt().front().lower; isCt() && volume->maximum >= bone)
        return {std::max(bone, volume->minimum), volume->maximum};
    const std::vector<Interval> two = parts(1);
    return two.empty() ? Interval(volume->minimum, volume->maximum) : two.back();
}

void IntervalSuggestions::stopPicking()
{
    m_pick->setChecked(false);
}

void IntervalSuggestions::suggest(const Interval& interval)
{
    const core::Volume* volume = m_workspace.volume();
    if (volume)
        Q_EMIT suggested(std::clamp(interval.first, volume->minimum, volume->maximum),
            std::clamp(interval.second, volume->minimum, volume->maximum));
}

std::vector<IntervalSuggestions::Interval> IntervalSuggestions::parts(int thresholds) const
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return {};
    std::vector<Interval> all;
    double lower = volume->minimum;
    for (const double threshold : core::otsuThresholds(volume->histogram, thresholds)) {
        const int code = volume->encoding.lowestCodeAtLeast(threshold);
        if (code == 0 || code >= core::VoxelEncoding::codeCount)
            continue;
        all.emplace_back(lower, volume->encoding.value(code - 1));
        lower = volume->encoding.value(code);
    }
    if (all.empty())
        return {};
    all.emplace_back(lower, volume->maximum);
    return all;
}

void IntervalSuggestions::offerParts(QMenu& menu, int thresholds)
{
    const core::Volume* volume = m_workspace.volume();
    for (const Interval& part : parts(thresholds))
        menu.addAction(intervalText(part, volume->unit), this, [this, part] { suggest(part); });
    if (menu.isEmpty())
        menu.addAction(tr("all values are alike"))->setEnabled(false);
}

void IntervalSuggestions::offerTissues(QMenu& menu)
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return;
    for (const Tissue& tissue : tissuesOfCt()) {
        const Interval within{
            std::max(tissue.lower, volume->minimum), std::min(tissue.upper, volume->maximum)};
        const bool isThere = within.first <= within.second;
        const QString text = isThere
            ? QStringLiteral("%1  %2").arg(tissue.name, intervalText(within, volume->unit))
            : tissue.name;
        menu.addAction(text, this, [this, within] { suggest(within); })->setEnabled(isThere);
    }
}

/// Clicks are the tool's while one is active.
void IntervalSuggestions::pick(bool on)
{
    m_picked.reset();
    if (on)
        m_workspace.setActiveTool(nullptr);
}

/// The values of a voxel and its 26 neighbours: one alone would be noise.
void IntervalSuggestions::pickAtCrosshair()
{
    core::EditSession* session = m_workspace.session();
    if (!m_pick->isChecked() || !session)
        return;
    const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
    const glm::ivec3 middle(glm::floor(geometry.toIndex(m_workspace.crosshairLps()) + 0.5));
    std::vector<glm::ivec3> voxels;
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const glm::ivec3 voxel = middle + glm::ivec3(x, y, z);
                if (geometry.contains(voxel))
                    voxels.push_back(voxel);
            }
        }
    }
    if (voxels.empty())
        return;
    session->questions().probe(std::move(voxels),
        [self = QPointer(this)](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
            if (!self || !probes || probes->empty() || !self->m_pick->isChecked())
                return;
            const auto [least, greatest] = std::minmax_element(probes->begin(), probes->end(),
                [](const core::ProbedVoxel& one, const core::ProbedVoxel& other) {
                    return one.code < other.code;
                });
            const core::VoxelEncoding& encoding = self->m_workspace.volume()->encoding;
            Interval seen{encoding.value(least->code), encoding.value(greatest->code)};
            if (self->m_picked)
                seen = {std::min(seen.first, self->m_picked->first),
                    std::max(seen.second, self->m_picked->second)};
            self->m_picked = seen;
            self->suggest(seen);
        });
}

} // namespace ui
