// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceUpdate.h"
#include "tests/support/faults/RefusingGl.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>

namespace frameSchedulerGlTest {

using namespace gpu;

class FrameSchedulerGlTest : public test::FrameTest {
    Q_OBJECT

    void openBall()
    {
        m_fixture->open(test::centredGeometry({48, 48, 48}),
            [](const glm::dvec3& lps) { return 1000.0 - 30.0 * glm::length(lps); });
    }
    [[nodiscard]] static FrameRequest volumeRequest(ViewId view, glm::ivec2 size = {200, 150})
    {
        VolumeScene scene;
        scene.heightMm = 60.0;
        scene.surfaceThreshold = 500.0;
        FrameRequest request;
        request.view = view;
        request.sizePixels = size;
        request.scene = scene;
        return request;
    }
    [[nodiscard]] static FrameRequest sliceRequest(ViewId view, double z)
    {
        SliceScene scene;
        scene.centreLps = {0.0, 0.0, z};
        scene.mmPerPixel = 0.5;
        scene.window = {500.0, 1000.0};
        FrameRequest request;
        request.view = view;
        request.sizePixels = {100, 100};
        request.scene = scene;
        return request;
    }

    /// A small picture of view 1 with what its name says.
    [[nodiscard]] FrameRequest requestOf(const QString& what)
    {
        FrameRequest request = volumeRequest(1);
        if (what == QLatin1String("volume"))
            return request;
        if (what == QLatin1String("slice"))
            request = sliceRequest(1, 0.0);
        request.sizePixels = {90, 70};
        request.segments.visible[1] = true;
        auto* scene = std::get_if<VolumeScene>(&request.scene);
        if (!scene)
            return request;
        if (what == QLatin1String("maximum intensity")) {
            scene->mode = RenderMode::Mip;
            scene->mipWindow = {500.0, 1000.0};
        } else if (what == QLatin1String("cutting plane")) {
            scene->plane = ScenePlane{.halfSizeMm = {20.0, 20.0}, .window = {500.0, 1000.0}};
        } else if (what == QLatin1String("surface")) {
            m_fixture->scheduler.updateSurface(
                core::wholeUpdate(test::simplexMesh(test::icosphere(18.0, 2))));
            scene->surface = SceneSurface{};
        } else {
            scene->seeds = std::make_shared<const std::vector<SceneSeed>>(
                std::vector<SceneSeed>{{.lps = {0.0, -16.0, 0.0}, .label = 1}});
        }
        return request;
    }

private Q_SLOTS:
    void init()
    {
        m_fixture.emplace();
        openBall();
    }

    void refinesThenRests()
    {
        m_fixture->scheduler.request(volumeRequest(1));
        QCOMPARE(m_fixture->wakeUps, 1);
        const std::vector<Frame> frames = m_fixture->settle();
        QVERIFY(frames.size() >= 2);
        QCOMPARE(frames[frames.size() - 2].quality, Frame::Quality::Full);
        QCOMPARE(frames.back().quality, Frame::Quality::Refined);
        for (const Frame& frame : frames)
            QCOMPARE(frame.rgba->size(), std::size_t(200 * 150 * 4));
        const auto tiles = m_fixture->scheduler.counters().tiles;
        for (int i = 0; i < 100; ++i)
            QVERIFY(!m_fixture->scheduler.work(false));
        // The same request again, or one that only stops interacting, is no work either.
        m_fixture->scheduler.request(volumeRequest(1));
        QVERIFY(m_fixture->settle().empty());
        QCOMPARE(m_fixture->scheduler.counters().tiles, tiles);
    }

    /// Kernels are made ready for the edits that a window's picture is followed by, and for none
    /// after a picture that stands alone.
    void aSinglePictureMakesNothingReady()
    {
        FrameRequest request = volumeRequest(1);
        request.single = true;
        m_fixture->scheduler.request(request);
        QCOMPARE(m_fixture->settle().back().quality, Frame::Quality::Refined);
        QCOMPARE(m_fixture->edits.warmUps, 0);
        m_fixture->scheduler.request(volumeRequest(2));
        QCOMPARE(m_fixture->settle().back().quality, Frame::Quality::Refined);
        QVERIFY(m_fixture->edits.warmUps > 0);
    }

    void slicesAreFinalAtOnce()
    {
        m_fixture->scheduler.request(sliceRequest(1, 0.0));
        const std::vector<Frame> frames = m_fixture->settle();
        QVERIFY(!frames.empty());
        QCOMPARE(frames.back().quality, Frame::Quality::Refined);
        QVERIFY(std::none_of(frames.begin(), frames.end(),
            [](const Frame& frame) { return frame.quality == Frame::Quality::Full; }));
    }

    void noRefinementWhileInteracting()
    {
        FrameRequest request = volumeRequest(1, {480, 420});
        request.interacting = true;
        m_fixture->scheduler.request(request);
        std::vector<Frame> frames = m_fixture->settle();
        QVERIFY(std::none_of(frames.begin(), frames.end(),
            [](const Frame& frame) { return frame.quality == Frame::Quality::Refined; }));
        QVERIFY(!frames.empty());
        request.interacting = false;
        m_fixture->scheduler.request(request);
        frames = m_fixture->settle();
        QVERIFY(!frames.empty());
        QCOMPARE(frames.back().quality, Frame::Quality::Refined);
    }

    void theLatestRequestWins()
    {
        FrameRequest request = volumeRequest(1);
        m_fixture->scheduler.request(request);
        std::get<VolumeScene>(request.scene).heightMm = 30.0;
        m_fixture->scheduler.request(request);
        for (const Frame& frame : m_fixture->settle())
            QCOMPARE(std::get<VolumeScene>(frame.scene).heightMm, 30.0);
        // In the middle of a picture too: it is given up.
        m_fixture->scheduler.request(volumeRequest(1, {480, 420}));
        QVERIFY(m_fixture->scheduler.work(false));
        std::get<VolumeScene>(request.scene).heightMm = 40.0;
        m_fixture->scheduler.request(request);
        const std::vector<Frame> frames = m_fixture->settle();
        QCOMPARE(std::get<VolumeScene>(frames.back().scene).heightMm, 40.0);
        QCOMPARE(frames.back().sizePixels, request.sizePixels);
    }

    /// A hand asks for another picture before the last one is finished, time and again.
    void whoMovesOnSeesPictures()
    {
        FrameRequest request = volumeRequest(1, {480, 420});
        request.interacting = true;
        constexpr int moves = 80;
        for (int move = 0; move < moves; ++move) {
            std::get<VolumeScene>(request.scene).heightMm = 60.0 - 0.1 * move;
            m_fixture->scheduler.request(request);
            static_cast<void>(m_fixture->scheduler.work(false));
        }
        // Fewer than moves, since a picture takes several slices.
        QVERIFY2(m_fixture->scheduler.counters().frames >= 3,
            qPrintable(QString::number(m_fixture->scheduler.counters().frames)));
        request.interacting = false;
        m_fixture->scheduler.request(request);
        const std::vector<Frame> frames = m_fixture->settle();
        double last = 60.1;
        for (const Frame& frame : frames) {
            const double heightMm = std::get<VolumeScene>(frame.scene).heightMm;
            QVERIFY(heightMm <= last);
            last = heightMm;
        }
        QCOMPARE(last, 60.0 - 0.1 * (moves - 1));
        QCOMPARE(frames.back().quality, Frame::Quality::Refined);
    }

    void picturesDoNotDependOnHowTheyWereCut()
    {
        const Frame first = m_fixture->draw(volumeRequest(1).scene, {233, 122});
        // Now the cost of a tile is known: other cuts.
        const Frame second = m_fixture->draw(volumeRequest(1).scene, {233, 122});
        QVERIFY(*first.rgba == *second.rgba);
        m_fixture.emplace();
        openBall();
        QVERIFY(*m_fixture->draw(volumeRequest(1).scene, {233, 122}).rgba == *first.rgba);
    }

    void resizingGivesTheNewSize()
    {
        for (const glm::ivec2 size : {glm::ivec2(64, 64), glm::ivec2(301, 77), glm::ivec2(1, 1)}) {
            m_fixture->scheduler.request(volumeRequest(1, size));
            const std::vector<Frame> frames = m_fixture->settle();
            QCOMPARE(frames.back().sizePixels, size);
            QCOMPARE(frames.back().rgba->size(), std::size_t(size.x * size.y * 4));
        }
        m_fixture->scheduler.request(volumeRequest(1, {0, 10}));
        QVERIFY(m_fixture->settle().empty());
    }

    void onlyAffectedViewsAreDrawnAgain()
    {
        m_fixture->scheduler.request(sliceRequest(1, 0.0));
        m_fixture->scheduler.request(sliceRequest(2, 15.0));
        m_fixture->scheduler.request(volumeRequest(3));
        (void)m_fixture->settle();
        const auto views = [](const std::vector<Frame>& frames) {
            QList<int> ids;
            for (const Frame& frame : frames)
                if (frame.quality == Frame::Quality::Refined)
                    ids.append(frame.view);
            std::sort(ids.begin(), ids.end());
            return ids;
        };
        // Voxel k = 23.5 + z.
        m_fixture->fill(VolumeField::Labels, {{10, 10, 22}, {20, 20, 25}}, 1);
        QCOMPARE(views(m_fixture->settle()), QList<int>({1}));
        m_fixture->fill(VolumeField::Radiation, {{10, 10, 37}, {20, 20, 40}}, 255);
        QCOMPARE(views(m_fixture->settle()), QList<int>({2, 3}));
        m_fixture->fill(VolumeField::Segmentation, {{10, 10, 22}, {20, 20, 25}}, 255);
        QCOMPARE(views(m_fixture->settle()), QList<int>({3}));
        QVERIFY(m_fixture->settle().empty());
    }

    void whileEditingPicturesStayCoarse()
    {
        m_fixture->scheduler.request(volumeRequest(1, {480, 420}));
        (void)m_fixture->settle();
        m_fixture->fill(VolumeField::Radiation, {{20, 0, 20}, {28, 10, 28}}, 255);
        const auto before = m_fixture->scheduler.counters().frames;
        for (int i = 0; i < 1000 && m_fixture->scheduler.work(true); ++i) { }
        const auto during = m_fixture->scheduler.counters().frames - before;
        QVERIFY2(during == 1, qPrintable(QString::number(during)));
        QCOMPARE(m_fixture->settle().back().quality, Frame::Quality::Refined);
    }

    void changesBeforeTheFirstFrameCount()
    {
        const glm::ivec3 whole =
            test::pixel(m_fixture->draw(volumeRequest(1).scene, {60, 60}), 30, 30);
        QVERIFY(whole.r > 50);
        m_fixture.emplace();
        openBall();
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 0}, {48, 48, 48}}, 255);
        const Frame carved = m_fixture->draw(volumeRequest(1).scene, {60, 60});
        QCOMPARE(test::pixel(carved, 30, 30), glm::ivec3(0));
    }

    void forgottenViewsAreSilent()
    {
        m_fixture->scheduler.request(volumeRequest(1));
        QVERIFY(m_fixture->scheduler.work(false));
        m_fixture->scheduler.forget(1);
        QVERIFY(m_fixture->settle().empty());
        // Asked for again it begins anew, although the request is the same.
        m_fixture->scheduler.request(volumeRequest(1));
        QVERIFY(!m_fixture->settle().empty());
        m_fixture->scheduler.forget(1);
        m_fixture->scheduler.request(volumeRequest(1));
        QVERIFY(!m_fixture->settle().empty());
    }

    void shownSegmentsReachTheEditEngine()
    {
        FrameRequest request = volumeRequest(1);
        request.segments.visible[4] = true;
        request.segments.visible[0] = true; // label 0 is no segment
        m_fixture->scheduler.request(request);
        (void)m_fixture->settle();
        QCOMPARE(m_fixture->edits.shown.to_ullong(), 1ull << 4);
    }

    void refusedMemoryIsSaid_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what :
            {"volume", "slice", "maximum intensity", "cutting plane", "surface", "seeds"})
            QTest::addRow("%s", what) << QString::fromLatin1(what);
    }
    /// Wherever the GPU refuses memory, that is said once, and the next picture is drawn as ever.
    void refusedMemoryIsSaid()
    {
        QFETCH(QString, what);
        m_fixture->fill(VolumeField::Labels, {{20, 20, 20}, {28, 28, 28}}, 1);
        m_fixture->fill(VolumeField::Segmentation, {{20, 20, 20}, {28, 28, 28}}, 255);
        const FrameRequest request = requestOf(what);
        m_fixture->scheduler.request(request);
        const std::vector<Frame> first = m_fixture->settle();
        QVERIFY(!first.empty() && first.back().rgba);
        const auto expected = first.back().rgba;
        const auto anew = [&] {
            m_fixture->scheduler.forget(1);
            m_fixture->scheduler.request(request);
            return m_fixture->settle();
        };
        int calls = 0;
        {
            const test::RefusingGl counting(0);
            QVERIFY(*anew().back().rgba == *expected);
            calls = counting.calls();
        }
        QVERIFY(calls >= (what == QLatin1String("volume") ? 3 : 1));
        for (int call = 1; call <= calls; ++call) {
            {
                const test::RefusingGl refusing(call);
                const std::vector<Frame> frames = anew();
                QCOMPARE(frames.size(), std::size_t(1));
                QVERIFY(frames[0].failure && !frames[0].rgba);
                QCOMPARE(frames[0].failure->code, core::ErrorCode::OutOfMemory);
                QVERIFY(m_fixture->settle().empty());
            }
            const std::vector<Frame> after = anew();
            QVERIFY(!after.back().failure && *after.back().rgba == *expected);
        }
        QVERIFY(newErrors() >= calls);
    }

    /// What could not be drawn is drawn when it is asked for again, though nothing else has
    /// changed.
    void theSameRequestIsDrawnAfterItFailed()
    {
        const FrameRequest request = volumeRequest(1);
        m_fixture->scheduler.request(request);
        const auto expected = m_fixture->settle().back().rgba;
        m_fixture->scheduler.forget(1);
        {
            const test::RefusingGl refusing(1);
            m_fixture->scheduler.request(request);
            const std::vector<Frame> frames = m_fixture->settle();
            QCOMPARE(frames.size(), std::size_t(1));
            QVERIFY(frames[0].failure);
        }
        QVERIFY(m_fixture->settle().empty());
        m_fixture->scheduler.request(request);
        const std::vector<Frame> after = m_fixture->settle();
        QVERIFY(!after.empty() && !after.back().failure);
        QCOMPARE(after.back().quality, Frame::Quality::Refined);
        QVERIFY(*after.back().rgba == *expected);
        // From then on it is no work again.
        m_fixture->scheduler.request(request);
        QVERIFY(m_fixture->settle().empty());
        QVERIFY(newErrors() >= 1);
    }

    /// A surface that there was no memory for is shown as soon as there is.
    void aSurfaceWaitsForMemory()
    {
        const FrameRequest request = requestOf(QStringLiteral("surface"));
        m_fixture->scheduler.request(request);
        const auto expected = m_fixture->settle().back().rgba;
        int calls = 2;
        for (int call = 0; call <= calls; ++call) {
            m_fixture.emplace();
            openBall();
            {
                const test::RefusingGl refusing(call);
                (void)requestOf(QStringLiteral("surface"));
                (void)m_fixture->settle();
                if (call == 0)
                    calls = refusing.calls();
            }
            m_fixture->scheduler.request(request);
            const std::vector<Frame> after = m_fixture->settle();
            QVERIFY(!after.empty() && !after.back().failure);
            QVERIFY2(*after.back().rgba == *expected, qPrintable(QString::number(call)));
        }
        QVERIFY(calls >= 2);
        QVERIFY(newErrors() >= calls);
    }

    /// A shader that the driver refuses is said, and asked for again by the next picture.
    void refusedShaderIsSaid()
    {
        m_fixture->scheduler.request(volumeRequest(1));
        const auto expected = m_fixture->settle().back().rgba;
        int calls = 0;
        {
            m_fixture.emplace();
            openBall();
            const test::RefusingGl counting(test::RefusingGl::Shader{0});
            m_fixture->scheduler.request(volumeRequest(1));
            QVERIFY(*m_fixture->settle().back().rgba == *expected);
            calls = counting.calls();
        }
        QVERIFY(calls > 0);
        const int tried = std::min(calls, 3);
        for (int i = 0; i < tried; ++i) {
            m_fixture.emplace();
            openBall();
            {
                const test::RefusingGl refusing(test::RefusingGl::Shader{1 + i * calls / tried});
                m_fixture->scheduler.request(volumeRequest(1));
                const std::vector<Frame> frames = m_fixture->settle();
                QVERIFY(!frames.empty());
                QVERIFY(frames.back().failure && !frames.back().rgba);
                QCOMPARE(frames.back().failure->code, core::ErrorCode::GraphicsUnavailable);
                QCOMPARE(std::count_if(frames.begin(), frames.end(),
                             [](const Frame& frame) { return frame.failure.has_value(); }),
                    std::ptrdiff_t(1));
            }
            m_fixture->scheduler.forget(1);
            m_fixture->scheduler.request(volumeRequest(1));
            const std::vector<Frame> after = m_fixture->settle();
            QVERIFY(!after.back().failure && *after.back().rgba == *expected);
        }
        (void)newErrors(); // some drivers tell of a refused shader, too
    }

    void withoutAVolumeItIsBlack()
    {
        m_fixture.emplace();
        m_fixture->scheduler.request(volumeRequest(1));
        const std::vector<Frame> frames = m_fixture->settle();
        QCOMPARE(frames.size(), std::size_t(1));
        QCOMPARE(test::pixel(frames[0], 100, 75), glm::ivec3(0));
        openBall();
        const std::vector<Frame> drawn = m_fixture->settle();
        QVERIFY(!drawn.empty());
        QVERIFY(test::pixel(drawn.back(), 100, 75).r > 50);
    }
};

BURIN_TEST(FrameSchedulerGlTest)

} // namespace frameSchedulerGlTest

#include "FrameSchedulerGlTest.moc"
