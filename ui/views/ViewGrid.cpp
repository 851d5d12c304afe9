// SPDX-License-Identifier: Apache-2.0
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QGridLayout>

#include <algorithm>

namespace ui {

ViewGrid::ViewGrid(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_inbox(workspace.frames())
    , m_axial(new SliceView(workspace, 1, SliceOrientation::Axial, this))
    , m_volume(new VolumeView(workspace, 2, this))
    , m_sagittal(new SliceView(workspace, 3, SliceOrientation::Sagittal, this))
    , m_coronal(new SliceView(workspace, 4, SliceOrientation::Coronal, this))
    , m_current(m_axial)
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_axial, 0, 0);
    layout->addWidget(m_volume, 0, 1);
    layout->addWidget(m_sagittal, 1, 0);
    layout->addWidget(m_coronal, 1, 1);

    m_axial->setObjectName(QStringLiteral("axialView"));
    m_volume->setObjectName(QStringLiteral("volumeView"));
    m_sagittal->setObjectName(QStringLiteral("sagittalView"));
    m_coronal->setObjectName(QStringLiteral("coronalView"));
    for (ImageView* view : views()) {
        connect(view, &ImageView::maximiseToggled, this,
            [this, view] { maximise(m_maximised ? nullptr : view); });
        connect(view, &ImageView::qualityChanged, this, &ViewGrid::pictureChanged);
    }
    connect(&m_inbox, &FrameInbox::arrived, this, &ViewGrid::give);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (auto* view = qobject_cast<ImageView*>(now); view && isAncestorOf(view))
            m_current = view;
    });
}

std::array<ImageView*, 4> ViewGrid::views() const
{
    return {m_axial, m_volume, m_sagittal, m_coronal};
}

void ViewGrid::give(const gpu::Frame& frame)
{
    for (ImageView* view : views()) {
        if (view->viewId() == frame.view)
            view->takeFrame(frame);
    }
    Q_EMIT frameTimed(frame.renderMilliseconds);
}

void ViewGrid::maximise(ImageView* view)
{
    m_maximised = view;
    // Equal rows and columns for four; nothing for what is hidden.
    for (ImageView* each : views())
        each->setVisible(!view || each == view);
    auto* grid = static_cast<QGridLayout*>(layout());
    for (int part = 0; part < 2; ++part) {
        const auto shown = [&](ImageView* a, ImageView* b) {
            return !view || a == view || b == view;
        };
        grid->setColumnStretch(
            part, part == 0 ? shown(m_axial, m_sagittal) : shown(m_volume, m_coronal));
        grid->setRowStretch(
            part, part == 0 ? shown(m_axial, m_volume) : shown(m_sagittal, m_coronal));
    }
    if (view)
        view->setFocus();
    Q_EMIT layoutChanged();
}

void ViewGrid::resetViews()
{
    for (ImageView* view : views())
        view->resetView();
}

bool ViewGrid::showEarlySlice(const std::shared_ptr<const core::EarlySlice>& early)
{
    const auto slices = {m_axial, m_sagittal, m_coronal};
    const bool isSeen = early
        && std::any_of(slices.begin(), slices.end(),
            [&](const SliceView* view) { return view->looksAt(*early); });
    m_early = isSeen ? early : nullptr;
    for (ImageView* view : views())
        view->showEarlySlice(m_early);
    return isSeen;
}

bool ViewGrid::refined() const
{
    const auto all = views();
    return std::all_of(all.begin(), all.end(), [](const ImageView* view) {
        return !view->isVisible() || view->quality() == gpu::Frame::Quality::Refined;
    });
}

} // namespace ui
