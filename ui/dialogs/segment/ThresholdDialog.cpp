// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/ThresholdDialog.h"

#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "core/session/past/FollowedInterval.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/segment/EditTrial.h"
#include "ui/dialogs/segment/IntervalSuggestions.h"
#include "ui/dialogs/segment/PreviewBox.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/widgets/HistogramRange.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace ui {

namespace {

QCheckBox* box(const char* name, const QString& text, const QString& tip, QWidget* parent)
{
    auto* made = new QCheckBox(text, parent);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    return made;
}

} // namespace

ThresholdDialog::ThresholdDialog(Workspace& workspace, QWidget* parent)
    : SegmentDialog(workspace, tr("Threshold"), QStringLiteral("threshold"), parent)
    , m_trial(new EditTrial(workspace, EditTrial::Pace::AtOnce, this))
{
    build();
    connect(m_range, &HistogramRange::rangeEdited, this, &ThresholdDialog::follow);
    connect(m_range, &HistogramRange::rangeCancelled, this, &ThresholdDialog::follow);
    connect(m_boxed, &QCheckBox::toggled, this, [this] { m_itsBox.reset(); });
    for (const QCheckBox* each :
        std::initializer_list<const QCheckBox*>{m_overwrite, m_onlyVisible, m_boxed, m_preview})
        connect(each, &QCheckBox::toggled, this, &ThresholdDialog::follow);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &ThresholdDialog::follow);
    connect(
        m_suggestions, &IntervalSuggestions::suggested, this, [this](double lower, double upper) {
            m_range->setRange(lower, upper);
            m_range->showRange();
            follow();
        });
    connect(m_apply, &QPushButton::clicked, this, &ThresholdDialog::carryOut);
    connect(m_trial, &EditTrial::changed, this, &ThresholdDialog::showState);
    connect(&workspace, &Workspace::documentChanged, this, &ThresholdDialog::showState);
    connect(&workspace, &Workspace::clipChanged, this, [this] {
        showState();
        if (isVisible() && m_boxed->isChecked())
            follow();
    });
    connect(&workspace, &Workspace::editableChanged, this, &ThresholdDialog::follow);
    connect(m_limit, &QPushButton::clicked, this, &ThresholdDialog::limitEditing);
    connect(&workspace, &Workspace::sessionChanged, this, [this] { m_isFresh = true; });
}

void ThresholdDialog::build()
{
    m_follows =
        new QLabel(tr("This segment follows its interval: moving it works it out anew"), this);
    m_follows->setObjectName(QStringLiteral("thresholdFollows"));
    m_follows->setFont(theme::smallFont());
    m_follows->setProperty("role", QStringLiteral("secondary"));
    m_range = new HistogramRange(this);
    m_range->setObjectName(QStringLiteral("thresholdInterval"));
    m_range->setMinimumWidth(380);
    m_suggestions = new IntervalSuggestions(workspace(), this);
    m_mode = new QComboBox(this);
    m_mode->setObjectName(QStringLiteral("thresholdMode"));
    m_mode->setAccessibleName(tr("What is done with these voxels"));
    m_mode->addItem(tr("The segment becomes these voxels")); // as ThresholdSegment::Mode
    m_mode->addItem(tr("Add these voxels to it"));
    m_mode->addItem(tr("Take these voxels from it"));
    m_overwrite = box("thresholdOverwrite", tr("overwrite"),
        tr("Take voxels of other segments that are not locked"), this);
    m_onlyVisible = box("thresholdOnlyVisible", tr("only what is not carved away"),
        tr("What is carved away stays as it is"), this);
    m_boxed = box("thresholdBoxed", tr("only in the clip box"),
        tr("What lies outside of the clip box stays as it is"), this);
    m_preview = new PreviewBox(QStringLiteral("threshold"), this);
    m_now = new QLabel(this);
    m_now->setObjectName(QStringLiteral("thresholdNow"));
    m_now->setFont(theme::smallFont());
    m_now->setProperty("role", QStringLiteral("secondary"));
    m_now->setMinimumHeight(
        2 * QFontMetrics(theme::smallFont()).lineSpacing()); // as with a preview
    m_limit = new QPushButton(tr("As editable range"), this);
    m_limit->setObjectName(QStringLiteral("thresholdAsRange"));
    m_limit->setToolTip(tr("From now on all tools change only voxels with these values"));
    m_limit->setAutoDefault(false);
    m_apply = new QPushButton(tr("Apply"), this);
    m_apply->setObjectName(QStringLiteral("applyThreshold"));
    m_apply->setDefault(true);
    auto* close = new QPushButton(tr("Close"), this);
    close->setAutoDefault(false);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);

    auto* mode = new QHBoxLayout;
    mode->setSpacing(theme::smallPadding);
    mode->addWidget(m_mode, 1);
    mode->addWidget(m_overwrite);
    auto* limits = new QHBoxLayout;
    limits->setSpacing(theme::smallPadding);
    limits->addWidget(m_onlyVisible);
    limits->addWidget(m_boxed);
    limits->addStretch(1);
    limits->addWidget(m_preview);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(theme::smallPadding);
    buttons->addWidget(m_now, 1);
    buttons->addWidget(m_limit);
    buttons->addWidget(m_apply);
    buttons->addWidget(close);
    column().addWidget(m_follows);
    column().addWidget(m_range);
    column().addWidget(m_suggestions);
    column().addLayout(mode);
    column().addLayout(limits);
    addEditable();
    column().addSpacing(theme::smallPadding);
    column().addLayout(buttons);
}

void ThresholdDialog::ask(int label)
{
    setLabel(label);
    const core::Volume* volume = workspace().volume();
    if (m_isFresh && volume) {
        m_range->setHistogram(volume->histogram, volume->unit);
        const auto [lower, upper] = m_suggestions->first();
        m_range->setRange(lower, upper);
        m_isFresh = false;
    }
    takeFollowed();
    showState();
    bringUp();
    follow();
}

std::optional<core::ThresholdSegment> ThresholdDialog::followed() const
{
    const core::Segment* about = segment();
    return about ? core::followedInterval(*about, workspace().session()->history()) : std::nullopt;
}

void ThresholdDialog::takeFollowed()
{
    if (m_itsBox)
        m_boxed->setChecked(false); // it was another segment's
    const std::optional<core::ThresholdSegment> interval = followed();
    if (!interval)
        return;
    const core::Volume& volume = *workspace().volume();
    const double lower = interval->lower.value_or(volume.minimum);
    m_range->setRange(lower, std::max(lower, interval->upper.value_or(volume.maximum)));
    m_range->showRange();
    m_mode->setCurrentIndex(int(interval->mode));
    m_overwrite->setChecked(interval->overwriteUnlocked);
    m_onlyVisible->setChecked(interval->onlyVisible);
    m_boxed->setChecked(interval->box.has_value());
    m_itsBox = interval->box; // switching the box off and on takes the clip box
}

void ThresholdDialog::setVisible(bool visible)
{
    if (!visible)
        m_suggestions->stopPicking();
    QDialog::setVisible(visible);
}

void ThresholdDialog::showState()
{
    SegmentDialog::showState();
    const core::Segment* about = segment();
    if (about) {
        const core::Volume& volume = *workspace().volume();
        const auto preview = [&volume](std::int64_t voxels) {
            return tr("Preview: %1").arg(countedText(volume, voxels));
        };
        // As wide as any count can be: a dialog that grows moves its buttons away.
        const auto all = std::int64_t(volume.geometry.voxelCount());
        m_now->setMinimumWidth(QFontMetrics(theme::smallFont()).horizontalAdvance(preview(all)));
        QString text = tr("Now: %1").arg(countedText(volume, about->voxels));
        if (const std::optional<std::int64_t> voxels = m_trial->voxels())
            text.prepend(preview(*voxels) + u'\n');
        else if (m_trial->isCounting())
            text.prepend(tr("Preview: counting …") + u'\n');
        m_now->setText(text);
    } else {
        m_now->clear();
    }
    m_follows->setVisible(followed().has_value());
    const QString why = whyUnchangeable(about);
    m_apply->setEnabled(why.isEmpty());
    m_apply->setToolTip(why);
    m_boxed->setEnabled(m_boxed->isChecked() || workspace().clip().box.on);
}

core::ThresholdSegment ThresholdDialog::chosen() const
{
    core::ThresholdSegment edit{.segment = label(),
        .lower = m_range->lower(),
        .upper = m_range->upper(),
        .mode = core::ThresholdSegment::Mode(m_mode->currentIndex()),
        .onlyVisible = m_onlyVisible->isChecked(),
        .overwriteUnlocked = m_overwrite->isChecked()};
    const core::ClipRegion::Box& clip = workspace().clip().box;
    if (m_boxed->isChecked() && m_itsBox)
        edit.box = m_itsBox;
    else if (m_boxed->isChecked() && clip.on)
        edit.box = growBoxFrom(clip, workspace().volume()->geometry);
    edit.editable = workspace().editableRange();
    return edit;
}

void ThresholdDialog::follow()
{
    if (isVisible() && m_preview->isChecked() && workspace().session())
        m_trial->show(chosen());
    else
        m_trial->drop();
}

void ThresholdDialog::limitEditing()
{
    EditableSettings settings = workspace().editableSettings();
    settings.on = true;
    settings.byValue = true;
    settings.lower = m_range->lower();
    settings.upper = m_range->upper();
    reject(); // seen through the range that it has chosen, it would show no difference
    workspace().setEditableSettings(settings);
    workspace().say(tr("%1; it is switched off beside the tool").arg(workspace().editableText()));
}

void ThresholdDialog::carryOut()
{
    if (!workspace().session())
        return;
    const core::ThresholdSegment edit = chosen();
    takeThreshold(workspace(), edit, m_trial->handOver(edit));
    showState();
}

} // namespace ui
