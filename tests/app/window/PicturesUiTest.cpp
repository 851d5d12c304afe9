// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/VoxelQuestions.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/Actions.h"
#include "ui/base/Theme.h"
#include "ui/geometry/OrientationLetters.h"
#include "ui/tools/aim/PickQuestion.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/StatusLine.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <optional>
#include <set>

namespace picturesUiTest {

// The window with the real engine: what the pictures show against where things are in the patient.

namespace {

using glm::dvec3;

/// A round body with one marker each towards the patient's left, front and head; no two alike.
struct Marker {
    dvec3 centreLps;
    double value;
    QLatin1String
        letter; ///< of its side; written down, or wrong letters would agree with themselves
};
const Marker left{{40.0, 0.0, 0.0}, 300.0, QLatin1String("L")};
const Marker front{{0.0, -40.0, 0.0}, 500.0, QLatin1String("A")};
const Marker head{{0.0, 0.0, 45.0}, 700.0, QLatin1String("S")};
constexpr double markerRadius = 9.0;

double valueAt(const dvec3& lps)
{
    for (const Marker& marker : {left, front, head}) {
        if (glm::length(lps - marker.centreLps) <= markerRadius)
            return marker.value;
    }
    return glm::length(lps / dvec3(56.0, 50.0, 58.0)) <= 1.0 ? 100.0 : -1000.0;
}

core::LoadedVolume patient(const glm::dmat4& indexToWorld)
{
    core::LoadedVolume loaded = test::plainCt(indexToWorld);
    const core::VolumeGeometry& geometry = loaded.volume.geometry;
    std::size_t next = 0;
    for (int k = 0; k < geometry.size.z; ++k) {
        for (int j = 0; j < geometry.size.y; ++j) {
            for (int i = 0; i < geometry.size.x; ++i)
                loaded.codes[next++] =
                    std::uint16_t(valueAt(geometry.toWorld(dvec3(i, j, k))) + 1024.0);
        }
    }
    loaded.volume.minimum = -1000.0;
    loaded.volume.maximum = 700.0;
    loaded.volume.defaultWindow = {350.0, 1000.0};
    return loaded;
}

class RealWindow {
public:
    /// @param file the session is kept there and continued from there; empty: in memory
    explicit RealWindow(core::LoadedVolume loaded, const QString& file = QString())
        : engine(std::move(*gpu::GpuEngine::create()))
        , workspace(engine->frames())
        , window(workspace, engine->rendererName())
    {
        ui::theme::apply(*qApp);
        engine->setVolumeGeometry(loaded.volume.geometry, loaded.volume.encoding);
        auto session = QFileInfo::exists(file)
            ? core::EditSession::open(engine->edits(), std::move(loaded), file)
            : core::EditSession::create(engine->edits(), std::move(loaded), {.file = file});
        if (!session)
            qFatal("no session");
        workspace.setSession(std::move(*session));
        poll.setInterval(5);
        QObject::connect(&poll, &QTimer::timeout, [this] { workspace.session()->poll(); });
        poll.start();
        window.resize(1000, 760);
        window.show();
    }
    ~RealWindow()
    {
        poll.stop();
        workspace.setSession(nullptr);
    }

    [[nodiscard]] bool waitUntilRefined()
    {
        return QTest::qWaitFor([this] { return window.views().refined(); }, 180000);
    }

    std::unique_ptr<gpu::GpuEngine> engine;
    ui::Workspace workspace;
    ui::MainWindow window;
    QTimer poll;
};

int greyAt(const ui::ImageView& view, const QPointF& at)
{
    const QRgb pixel = view.picture().pixel(int(at.x()), int(at.y()));
    return std::max({qRed(pixel), qGreen(pixel), qBlue(pixel)});
}

/// What window and level make of a value.
int greyOf(double value, const core::WindowLevel& window)
{
    return int(
        std::lround(255.0 * std::clamp((value - window.centre) / window.width + 0.5, 0.0, 1.0)));
}

} // namespace

} // namespace picturesUiTest

Q_DECLARE_METATYPE(glm::dvec3)

namespace picturesUiTest {

class PicturesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void noViewIsBlack();
    void markersLieWhereTheLettersSay_data();
    void markersLieWhereTheLettersSay();
    void crosshairIsOneVoxelInEveryView_data();
    void crosshairIsOneVoxelInEveryView();
    void whatTheVolumeViewShowsIsInTheSlices_data();
    void whatTheVolumeViewShowsIsInTheSlices();
    void slicesAreInterpolatedAsChosen();
    void continuedSessionLooksAsItWasLeft();
};

void PicturesUiTest::initTestCase()
{
    if (const auto engine = gpu::GpuEngine::create(); !engine)
        QSKIP("no OpenGL 4.5 here");
}

void PicturesUiTest::noViewIsBlack()
{
    RealWindow real(patient(test::headFirstSupine()));
    QVERIFY(real.waitUntilRefined());
    const QImage whole = real.window.grab().toImage();
    for (const ui::ImageView* view : real.window.views().views()) {
        if (!view->isVisible())
            continue;
        const QRect place(view->mapTo(&real.window, QPoint()), view->size());
        std::set<QRgb> colours;
        int lit = 0;
        for (int y = place.top(); y < place.bottom(); y += 3) {
            for (int x = place.left(); x < place.right(); x += 3) {
                const QRgb pixel = whole.pixel(x, y);
                colours.insert(pixel);
                lit += qGray(pixel) > 40;
            }
        }
        const int samples = (place.width() / 3) * (place.height() / 3);
        QVERIFY2(lit > samples / 20, qPrintable(view->title()));
        QVERIFY2(colours.size() > 12, qPrintable(view->title()));
    }
}

void PicturesUiTest::markersLieWhereTheLettersSay_data()
{
    QTest::addColumn<bool>("prone");
    QTest::newRow("head first supine") << false;
    QTest::newRow("head first prone") << true;
}

void PicturesUiTest::markersLieWhereTheLettersSay()
{
    QFETCH(bool, prone);
    RealWindow real(patient(prone ? test::headFirstProne() : test::headFirstSupine()));
    QVERIFY(real.waitUntilRefined());
    const core::WindowLevel window = real.workspace.windowLevel();
    for (const ui::ImageView* view : real.window.views().views()) {
        const ui::ViewContext shown = view->shownContext();
        if (!view->isVisible() || !shown.isSlice())
            continue;
        const auto& scene = std::get<gpu::SliceScene>(shown.scene);
        const QPointF middle(view->width() / 2.0, view->height() / 2.0);
        int sidesSeen = 0;
        for (const Marker& marker : {left, front, head}) {
            // The edge whose letter names the marker's side shows the marker.
            const QString side = marker.letter;
            const double pixels = glm::length(marker.centreLps) / scene.mmPerPixel;
            QPointF towards;
            if (ui::directionLetters(scene.rightLps) == side)
                towards = {1, 0};
            else if (ui::directionLetters(-scene.rightLps) == side)
                towards = {-1, 0};
            else if (ui::directionLetters(scene.downLps) == side)
                towards = {0, 1};
            else if (ui::directionLetters(-scene.downLps) == side)
                towards = {0, -1};
            else
                continue; // along the line of sight
            ++sidesSeen;
            QVERIFY(
                std::abs(greyAt(*view, middle + towards * pixels) - greyOf(marker.value, window))
                <= 2);
            QVERIFY(
                std::abs(greyAt(*view, middle - towards * pixels) - greyOf(100.0, window)) <= 2);
        }
        QCOMPARE(sidesSeen, 2);
    }
}

void PicturesUiTest::crosshairIsOneVoxelInEveryView_data()
{
    markersLieWhereTheLettersSay_data();
}

void PicturesUiTest::crosshairIsOneVoxelInEveryView()
{
    QFETCH(bool, prone);
    RealWindow real(patient(prone ? test::headFirstProne() : test::headFirstSupine()));
    const core::VolumeGeometry& geometry = real.workspace.volume()->geometry;
    const auto* status = real.window.findChild<ui::StatusLine*>();
    QVERIFY(status);
    for (const Marker& marker : {left, front, head}) {
        real.workspace.setCrosshairLps(marker.centreLps);
        QVERIFY(real.waitUntilRefined());
        for (const ui::ImageView* view : real.window.views().views()) {
            if (!view->isVisible() || !view->shownContext().isSlice())
                continue;
            QVERIFY(std::abs(greyAt(*view, view->crosshairPixel())
                        - greyOf(marker.value, real.workspace.windowLevel()))
                <= 2);
        }
        const glm::ivec3 voxel(glm::round(geometry.toIndex(marker.centreLps)));
        const QString expected = QStringLiteral("voxel %1, %2, %3 · %4 HU")
                                     .arg(voxel.x)
                                     .arg(voxel.y)
                                     .arg(voxel.z)
                                     .arg(marker.value);
        QTRY_VERIFY2(status->readout().contains(expected), qPrintable(status->readout()));
    }
}

void PicturesUiTest::whatTheVolumeViewShowsIsInTheSlices_data()
{
    QTest::addColumn<bool>("prone");
    QTest::addColumn<dvec3>("side");
    for (const bool prone : {false, true}) {
        const char* position = prone ? "prone" : "supine";
        QTest::addRow("%s, from the left", position) << prone << dvec3(1.0, 0.0, 0.0);
        QTest::addRow("%s, from the front", position) << prone << dvec3(0.0, -1.0, 0.0);
        QTest::addRow("%s, from above", position) << prone << dvec3(0.0, 0.0, 1.0);
        QTest::addRow("%s, from between", position) << prone << dvec3(0.7, -0.6, 0.4);
    }
}

/// What the engine finds under a pixel of the 3D picture is the surface's first voxel there; with
/// the crosshair on it, slices and 3D picture show that voxel's place and value.
void PicturesUiTest::whatTheVolumeViewShowsIsInTheSlices()
{
    QFETCH(bool, prone);
    QFETCH(dvec3, side);
    constexpr double threshold = 200.0; // markers alone are to be seen
    RealWindow real(patient(prone ? test::headFirstProne() : test::headFirstSupine()));
    const core::Volume& volume = *real.workspace.volume();
    const core::VolumeGeometry& geometry = volume.geometry;
    QVERIFY(real.waitUntilRefined());
    ui::Workspace::VolumeDisplay display = real.workspace.volumeDisplay();
    display.surfaceThreshold = threshold;
    real.workspace.setVolumeDisplay(display);
    ui::VolumeView& view = real.window.views().volume();
    view.lookFrom(side);
    QVERIFY(real.waitUntilRefined());
    const ui::ViewContext shown = view.shownContext();
    const auto& scene = std::get<gpu::VolumeScene>(shown.scene);
    const dvec3 towardsEye = glm::normalize(scene.eyeLps - scene.targetLps);
    const double voxelMm = glm::length(
        dvec3(geometry.indexToWorld[0] + geometry.indexToWorld[1] + geometry.indexToWorld[2]));

    int seen = 0;
    for (const Marker& marker : {left, front, head}) {
        const QPointF pixel = shown.toPixel(marker.centreLps);
        std::optional<glm::ivec3> hit;
        bool answered = false;
        real.workspace.session()->questions().pick(
            ui::pickQuestion(scene, {shown.toViewPlaneMm(pixel)}, volume),
            [&](const core::Result<ui::PickedVoxels>& picked) {
                answered = true;
                hit = picked->at(0);
            });
        QTRY_VERIFY_WITH_TIMEOUT(answered, 60000);
        QVERIFY(hit);
        // The surface lies between voxels' middles, so the hit is exact to a voxel.
        const dvec3 place = geometry.toWorld(dvec3(*hit));
        for (double mm = voxelMm; mm < 200.0; mm += 1.0)
            QVERIFY2(valueAt(place + towardsEye * mm) < threshold, qPrintable(QString::number(mm)));
        QVERIFY(greyAt(view, pixel) > 30);
        if (glm::length(place - marker.centreLps) > markerRadius + voxelMm)
            continue; // another marker stands before it
        ++seen;
        QVERIFY(glm::dot(place - marker.centreLps, towardsEye) > 0.0);
        // Half a radius behind what is seen there is nothing but the marker.
        real.workspace.setCrosshairLps(place - towardsEye * (markerRadius / 2.0));
        QVERIFY(real.waitUntilRefined());
        const QPointF cross = view.crosshairPixel();
        QVERIFY(std::hypot(cross.x() - pixel.x(), cross.y() - pixel.y())
            <= voxelMm / shown.mmPerPixel());
        for (const ui::ImageView* slice : real.window.views().views()) {
            if (!slice->isVisible() || !slice->shownContext().isSlice())
                continue;
            QVERIFY2(std::abs(greyAt(*slice, slice->crosshairPixel())
                         - greyOf(marker.value, real.workspace.windowLevel()))
                    <= 2,
                qPrintable(slice->title()));
        }
    }
    // Beside all markers the picture is empty.
    const QPointF beside = shown.toPixel(scene.targetLps + 58.0 * glm::normalize(scene.up));
    QVERIFY(greyAt(view, beside) < 10);
    QVERIFY(seen >= 2); // one marker may stand before another
}

void PicturesUiTest::slicesAreInterpolatedAsChosen()
{
    RealWindow real(patient(test::oblique()));
    const core::VolumeGeometry& geometry = real.workspace.volume()->geometry;
    const std::array<ui::SliceView*, 3> slices{&real.window.views().axial(),
        &real.window.views().sagittal(), &real.window.views().coronal()};
    const auto* status = real.window.findChild<ui::StatusLine*>();
    QTRY_VERIFY(!status->readout().isEmpty());
    const QString readout = status->readout();
    const auto pictures = [&](const char* way) {
        real.window.actionTable()[QStringLiteral("view.interpolation%1").arg(QLatin1String(way))]
            .trigger();
        std::vector<QImage> all;
        if (!real.waitUntilRefined())
            return all;
        for (const ui::SliceView* slice : slices)
            all.push_back(slice->picture().copy());
        return all;
    };
    const std::vector<QImage> nearest = pictures("Nearest");
    QCOMPARE(nearest.size(), slices.size());
    const core::WindowLevel window = real.workspace.windowLevel();
    for (std::size_t each = 0; each < slices.size(); ++each) {
        const ui::ViewContext shown = slices[each]->shownContext();
        int compared = 0;
        int edges = 0;
        for (int y = 0; y < nearest[each].height(); ++y) {
            for (int x = 0; x < nearest[each].width(); ++x) {
                const dvec3 index = geometry.toIndex(shown.toLps({x + 0.5, y + 0.5}));
                const dvec3 voxel = glm::round(index);
                const dvec3 beside = glm::abs(index - voxel);
                const bool isInside = glm::all(glm::greaterThanEqual(voxel, dvec3(0.0)))
                    && glm::all(glm::lessThan(voxel, dvec3(geometry.size)));
                if (!isInside || std::max({beside.x, beside.y, beside.z}) > 0.499)
                    continue;
                const int expected = greyOf(valueAt(geometry.toWorld(voxel)), window);
                ++compared;
                edges += std::abs(expected - greyOf(valueAt(geometry.toWorld(index)), window)) > 20;
                QVERIFY2(std::abs(qGray(nearest[each].pixel(x, y)) - expected) <= 2,
                    qPrintable(slices[each]->title()));
            }
        }
        QVERIFY(compared > 10000 && edges > 50);
    }
    const std::vector<QImage> linear = pictures("Linear");
    const std::vector<QImage> cubic = pictures("Cubic");
    const std::vector<QImage> usual = pictures("Usual");
    QVERIFY(linear.size() == slices.size() && cubic.size() == slices.size());
    for (std::size_t each = 0; each < slices.size(); ++each)
        QVERIFY(linear[each] != nearest[each] && cubic[each] != linear[each]);
    QVERIFY(usual == linear);
    // What is read is the voxel's value, whatever is drawn between voxels.
    QCOMPARE(status->readout(), readout);
}

void PicturesUiTest::continuedSessionLooksAsItWasLeft()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("session.burin"));
    const auto pictures = [](const RealWindow& real) {
        std::vector<QImage> all;
        for (const ui::ImageView* view : real.window.views().views())
            all.push_back(view->picture().copy());
        return all;
    };
    std::vector<QImage> untouched;
    std::vector<QImage> edited;
    {
        RealWindow real(patient(test::headFirstSupine()), file);
        QVERIFY(real.waitUntilRefined());
        untouched = pictures(real);
        core::EditSession& session = *real.workspace.session();
        const core::OrthographicView view{
            .eyeLps = {0.0, -500.0, 0.0}, .targetLps = {}, .up = {0.0, 0.0, 1.0}};
        const std::vector<core::PenSample> path{{10.0, 10.0, 1.0, 0.0}, {-20.0, 10.0, 1.0, 0.4}};
        QVERIFY(session.apply(test::drillWith({.view = view,
            .radiusMm = 12.0,
            .depthMm = 15.0,
            .surfaceThreshold = -350.0,
            .samples = path})));
        QVERIFY(session.apply(test::newSegment(QStringLiteral("S"), 0x3388ff)));
        QVERIFY(session.apply(test::seedAt(1, {front.centreLps})));
        QVERIFY(session.apply(test::growBetween(400.0, 600.0)));
        QVERIFY(session.settle());
        // Elsewhere and back: what comes then was drawn after the last edit.
        const dvec3 place = real.workspace.crosshairLps();
        real.workspace.setCrosshairLps(place + 6.0);
        real.window.views().volume().lookFrom({0.0, 1.0, 0.0});
        QVERIFY(real.waitUntilRefined());
        real.workspace.setCrosshairLps(place);
        real.window.views().volume().resetView();
        QVERIFY(real.waitUntilRefined());
        edited = pictures(real);
    }
    QVERIFY(edited[0] != untouched[0]);
    QVERIFY(edited[1] != untouched[1]);
    RealWindow real(patient(test::headFirstSupine()), file);
    QVERIFY(real.waitUntilRefined());
    const auto continued = pictures(real);
    for (std::size_t view = 0; view < edited.size(); ++view) {
        QCOMPARE(continued[view].size(), edited[view].size());
        QVERIFY2(continued[view] == edited[view], qPrintable(QString::number(view)));
    }
}

BURIN_WINDOW_TEST(PicturesUiTest)

} // namespace picturesUiTest

#include "PicturesUiTest.moc"
