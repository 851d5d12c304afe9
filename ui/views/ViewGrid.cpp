// SPDX-License-Identifier: Apache-2.0
#include "ui/views/ViewGrid.h"

#include "ui/workspace/CuttingPlane.h"

#include <QApplication>
#include <QEvent>
#include <QGridLayout>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

ViewGrid::ViewGrid(Workspace& workspace, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_inbox(workspace.frames())
    , m_boxWindow(workspace)
    , m_axial(new SliceView(workspace, 1, SliceOrientation::Axial, m_planes, this))
    , m_volume(new VolumeView(workspace, 2, this))
    , m_sagittal(new SliceView(workspace, 3, SliceOrientation::Sagittal, m_planes, this))
    , m_coronal(new SliceView(workspace, 4, SliceOrientation::Coronal, m_planes, this))
    , m_plane(new PlaneView(workspace, 5, this))
    , m_current(m_axial)
{
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_axial, 0, 0);
    layout->addWidget(m_volume, 0, 1);
    layout->addWidget(m_sagittal, 1, 0);
    layout->addWidget(m_coronal, 1, 1);
    layout->addWidget(m_plane, 0, 0); // where the axial view is, which it stands in for
    m_plane->hide();

    m_axial->setObjectName(QStringLiteral("axialView"));
    m_volume->setObjectName(QStringLiteral("volumeView"));
    m_sagittal->setObjectName(QStringLiteral("sagittalView"));
    m_coronal->setObjectName(QStringLiteral("coronalView"));
    m_plane->setObjectName(QStringLiteral("planeView"));
    for (ImageView* view : views()) {
        connect(view, &ImageView::maximiseToggled, this,
            [this, view] { maximise(m_maximised ? nullptr : view); });
        connect(view, &ImageView::qualityChanged, this, &ViewGrid::pictureChanged);
    }
    for (SliceView* slice : slices()) {
        connect(slice, &SliceView::placeChanged, this, [this, slice] { leadBy(*slice); });
        connect(slice, &SliceView::boxDrawn, this, [this](const core::Measurement& box) {
            awaitBox(false);
            m_boxWindow.setFrom(box);
        });
        connect(slice, &SliceView::boxAbandoned, this, [this] { awaitBox(false); });
    }
    m_plane->setReferencePlanes(m_planes);
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        awaitBox(false);
        m_planes.reset();
        // What waits is of the last study. The views, which were told before, have forgotten what
        // they asked for: no more of it comes.
        if (!m_workspace.volume())
            m_inbox.drop();
    });
    connect(&workspace, &Workspace::viewsCentred, this, &ViewGrid::centreOn);
    connect(&m_inbox, &FrameInbox::arrived, this, &ViewGrid::give);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (auto* view = qobject_cast<ImageView*>(now);
            view && (isAncestorOf(view) || view == m_plane))
            m_current = view;
    });
}

std::array<ImageView*, 5> ViewGrid::views() const
{
    return {m_axial, m_volume, m_sagittal, m_coronal, m_plane};
}

std::array<SliceView*, 4> ViewGrid::slices() const
{
    return {m_axial, m_sagittal, m_coronal, m_plane};
}

void ViewGrid::awaitBox(bool awaits)
{
    if (awaits == awaitsBox())
        return;
    for (SliceView* slice : slices())
        slice->setAwaitsBox(awaits);
    if (awaits)
        m_workspace.say(tr("Drag a box over a slice: its values set the grey scale. Esc: no box."));
    Q_EMIT awaitsBoxChanged();
}

void ViewGrid::leadBy(const SliceView& leader)
{
    if (!m_workspace.viewOptions().linkedPlaces)
        return;
    for (SliceView* slice : slices()) {
        if (slice != &leader)
            slice->lookWhereLooks(leader);
    }
}

void ViewGrid::centreOn(const glm::dvec3& placeLps)
{
    for (SliceView* slice : slices())
        slice->centreOn(placeLps);
    if (m_volume->isVisible() || !m_volume->fitted())
        m_volume->flyTo(placeLps, glm::dvec3(0.0));
}

void ViewGrid::give(const gpu::Frame& frame)
{
    for (ImageView* view : views()) {
        if (!view->takes(frame.view))
            continue;
        if (frame.failure)
            view->takeFailure();
        else
            view->takeFrame(frame);
    }
    if (frame.failure)
        return m_workspace.fail(*frame.failure);
    Q_EMIT frameTimed(frame.renderMilliseconds);
}

void ViewGrid::maximise(ImageView* view)
{
    // What has a window of its own is as large as that.
    m_maximised = view == m_plane && isPenApart() ? nullptr : view;
    place();
    if (m_maximised)
        m_maximised->setFocus();
}

void ViewGrid::arrange(Layout layout)
{
    m_layout = layout;
    m_maximised = nullptr;
    if (layout == Layout::PenAndStage)
        m_workspace.plane().show();
    place();
}

void ViewGrid::place()
{
    const bool four = m_layout == Layout::Four;
    const auto isShown = [&](const ImageView* view) {
        if (view == m_plane && isPenApart())
            return false;
        if (m_maximised)
            return view == m_maximised;
        return view == m_volume || (four ? view != m_plane : view == m_plane);
    };
    for (ImageView* view : views()) {
        if (view != m_plane || !isPenApart())
            view->setVisible(isShown(view));
    }
    // Equal rows and columns for those that are shown; nothing for what is hidden.
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->setColumnStretch(0, isShown(m_axial) || isShown(m_sagittal) || isShown(m_plane));
    grid->setColumnStretch(1, isShown(m_volume) || isShown(m_coronal));
    grid->setRowStretch(0, isShown(m_axial) || isShown(m_volume) || isShown(m_plane));
    grid->setRowStretch(1, isShown(m_sagittal) || isShown(m_coronal));
    Q_EMIT layoutChanged();
}

void ViewGrid::setPenApart(bool apart)
{
    if (apart == isPenApart())
        return;
    if (apart) {
        if (m_maximised == m_plane)
            m_maximised = nullptr;
        // A tool window: the keys of the main window work in it.
        m_penWindow = new QWidget(window(), Qt::Tool | Qt::WindowMaximizeButtonHint);
        m_penWindow->setWindowTitle(tr("Cutting plane"));
        m_penWindow->setObjectName(QStringLiteral("penWindow"));
        m_penWindow->resize(size() / 2);
        auto* box = new QVBoxLayout(m_penWindow);
        box->setContentsMargins(0, 0, 0, 0);
        box->addWidget(m_plane);
        m_penWindow->installEventFilter(this);
        m_plane->show();
        m_penWindow->show();
        m_workspace.plane().show();
    } else {
        static_cast<QGridLayout*>(layout())->addWidget(m_plane, 0, 0);
        m_penWindow->removeEventFilter(this);
        m_penWindow->deleteLater();
        m_penWindow = nullptr;
    }
    place();
}

bool ViewGrid::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_penWindow && event->type() == QEvent::Close) {
        setPenApart(false);
        return true;
    }
    switch (event->type()) {
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::Resize:
    case QEvent::Move:
        placeTexts(); // a view, or what lies over the views, has another place
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void ViewGrid::keepClearOf(QWidget& over)
{
    m_over = &over;
    over.installEventFilter(this);
    for (ImageView* view : views())
        view->installEventFilter(this);
    placeTexts();
}

void ViewGrid::placeTexts()
{
    const bool covers = m_over && m_over->isVisible();
    const QRect over = covers ? QRect(m_over->mapToGlobal(QPoint()), m_over->size()) : QRect();
    for (ImageView* view : views()) {
        const QRect place(view->mapToGlobal(QPoint()), view->size());
        view->setCoveredTop(
            view->isVisible() && view->window() == window() && over.intersects(place)
                ? std::clamp(over.bottom() + 1 - place.top(), 0, place.height() / 2)
                : 0);
    }
}

void ViewGrid::resetViews()
{
    m_planes.reset();
    for (ImageView* view : views())
        view->resetView();
}

void ViewGrid::addToMenus(const std::function<void(QMenu&)>& more)
{
    for (ImageView* view : views())
        view->addToMenus(more);
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

void ViewGrid::holdPictures(const QString& awaited)
{
    for (ImageView* view : views())
        view->holdPicture(awaited);
}

void ViewGrid::releasePictures()
{
    for (ImageView* view : views())
        view->releasePicture();
    Q_EMIT picturesReleased();
}

bool ViewGrid::holdsPictures() const
{
    const auto all = views();
    return std::any_of(
        all.begin(), all.end(), [](const ImageView* view) { return view->holdsPicture(); });
}

bool ViewGrid::refined() const
{
    const auto all = views();
    return std::all_of(all.begin(), all.end(), [](const ImageView* view) {
        return !view->isVisible() || view->quality() == gpu::Frame::Quality::Refined;
    });
}

} // namespace ui
