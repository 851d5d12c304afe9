// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QJsonDocument>
#include <QtTest>

#include <cmath>

namespace referencePeelTest {

using namespace core;
using reference::ReferenceEngine;
using test::Bytes;
using test::Codes;

namespace {

/// A volume whose middle is the target, seen along +z with +y up: right is −x.
struct Bench {
    glm::ivec3 size;
    glm::dvec3 spacing;
    Codes codes;
    Document document;
    OrthographicView view;
    ReferenceEngine engine;

    explicit Bench(const glm::ivec3& volumeSize, const glm::dvec3& voxel = glm::dvec3(1.0))
        : size(volumeSize)
        , spacing(voxel)
        , codes(test::constantVolume(volumeSize, 0))
    {
        Volume volume;
        volume.geometry.size = size;
        volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(spacing.x, 0, 0, 0),
            glm::dvec4(0, spacing.y, 0, 0), glm::dvec4(0, 0, spacing.z, 0), glm::dvec4(0, 0, 0, 1));
        document = initialDocument(volume);
        view.targetLps = middleMm();
        view.eyeLps = view.targetLps - glm::dvec3(0, 0, 300);
        view.up = {0.0, 1.0, 0.0};
    }
    [[nodiscard]] glm::dvec3 middleMm() const { return glm::dvec3(size - 1) * spacing / 2.0; }
    /// Tissue where a function of the position from the middle, in mm, says so; a grey edge of a
    /// voxel as a scanner has it.
    template <class Depth> void fill(const Depth& depthMm)
    {
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 p = glm::dvec3(x, y, z) * spacing - middleMm();
                    const double part = std::clamp(0.5 + depthMm(p) / spacing.x, 0.0, 1.0);
                    codes.at({x, y, z}) = std::uint16_t(std::lround(test::tissueCode * part));
                }
            }
        }
        (void)engine.openVolume(size, codes.values);
    }
    [[nodiscard]] PeelCut peel(double halfMm, double depthMm) const
    {
        PeelCut made;
        made.view = view;
        made.polygonMm = square(halfMm);
        made.depthMm = depthMm;
        made.surfaceThreshold = test::tissueCode / 2;
        return made;
    }
    [[nodiscard]] ScissorsCut scissors(double halfMm) const
    {
        ScissorsCut made;
        made.view = view;
        made.polygonMm = square(halfMm);
        made.surfaceThreshold = test::tissueCode / 2;
        return made;
    }
    static std::vector<glm::dvec2> square(double half)
    {
        return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    }
    EngineResult carryOut(const PeelCut& cut)
    {
        submitWhole(engine, *shellPeel(cut, document), {peelDepth(cut)});
        return test::lastResult(engine);
    }
    EngineResult carryOut(const ScissorsCut& cut)
    {
        submitWhole(engine, *outlineCut(cut, document));
        return test::lastResult(engine);
    }
    Bytes coverage()
    {
        reference::DenseFields fields = engine.fields();
        return fields.coverage(1);
    }
};

} // namespace

class ReferencePeelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void takesAnEvenShellOffABall_data()
    {
        QTest::addColumn<glm::dvec3>("spacing");
        QTest::newRow("1×1×1") << glm::dvec3(1.0);
        QTest::newRow("1×1×5") << glm::dvec3(1.0, 1.0, 5.0);
        QTest::newRow("8:1") << glm::dvec3(1.0, 1.0, 8.0);
    }
    void takesAnEvenShellOffABall()
    {
        QFETCH(glm::dvec3, spacing);
        Bench bench(glm::ivec3(glm::dvec3(64.0) / spacing), spacing);
        constexpr double radius = 26.0;
        // Half a voxel along the way inward, and what an element sees beside its middle.
        const double tolerance = 0.3 + 0.5 * spacing.z;
        const double depth = 4.0 + 1.25 * spacing.z;
        bench.fill([](const glm::dvec3& p) { return radius - glm::length(p); });
        QVERIFY(!bench.carryOut(bench.peel(20.0, depth)).changes.empty());
        const Bytes cut = bench.coverage();
        int peeled = 0;
        for (int z = 0; z < bench.size.z; ++z) {
            for (int y = 0; y < bench.size.y; ++y) {
                for (int x = 0; x < bench.size.x; ++x) {
                    const glm::dvec3 p = glm::dvec3(x, y, z) * spacing - bench.middleMm();
                    const double below = radius - glm::length(p);
                    const bool gone = cut.at({x, y, z}) >= 128;
                    const bool under =
                        std::abs(p.x) < 20.0 - depth && std::abs(p.y) < 20.0 - depth && p.z < 0.0;
                    if (under && below > tolerance && below < depth - tolerance) {
                        QVERIFY2(gone, qPrintable(QStringLiteral("%1 %2 %3").arg(x).arg(y).arg(z)));
                        ++peeled;
                    }
                    if (below > depth + tolerance || p.z > 10.0 || std::abs(p.x) > 21.5)
                        QVERIFY2(
                            !gone, qPrintable(QStringLiteral("%1 %2 %3").arg(x).arg(y).arg(z)));
                }
            }
        }
        QVERIFY(peeled > 50);
    }

    void goesBothWays()
    {
        Bench bench({48, 48, 40});
        bench.fill([](const glm::dvec3& p) { return 18.0 - glm::length(p); });
        const PeelCut drilled = bench.peel(5.0, 6.0);
        (void)bench.carryOut(drilled); // something that is there before
        const Bytes before = bench.coverage();
        const auto after = [&](std::initializer_list<double> depths) {
            ReferenceEngine engine;
            (void)engine.openVolume(bench.size, bench.codes.values);
            submitWhole(engine, *shellPeel(drilled, bench.document), {peelDepth(drilled)});
            const PeelCut peel = bench.peel(12.0, 1.0);
            engine.submit(BeginEdit{*shellPeel(peel, bench.document)});
            for (const double depthMm : depths)
                engine.submit(ExtendEdit{PeelDepth{int(depthMm * 65536)}});
            reference::DenseFields fields = engine.fields();
            return fields.coverage(1).values;
        };
        QVERIFY(after({}) == before.values);
        QVERIFY(after({5.0, 0.0}) == before.values);
        QVERIFY(after({5.0}) != before.values);
        QVERIFY(after({9.0, 1.0, 0.0, 5.0}) == after({5.0}));
        QVERIFY(after({3.0, 5.0}) == after({5.0}));
    }

    void leavesWhatIsSeenThroughAGap()
    {
        // A plate with a hole over a block.
        Bench bench({40, 40, 40});
        bench.fill([](const glm::dvec3& p) {
            const bool hole = std::abs(p.x) < 4.0 && std::abs(p.y) < 4.0;
            const bool plate = p.z > -15.0 && p.z < -10.0 && !hole;
            return plate || p.z > 8.0 ? 1.0 : -1.0;
        });
        PeelCut peel = bench.peel(12.0, 3.0);
        (void)bench.carryOut(peel);
        QVERIFY(bench.coverage().at({28, 20, 6}) >= 128);
        QVERIFY(bench.coverage().at({20, 20, 29}) < 128);
        peel.jumpMm = 0.0; // all that is seen
        (void)bench.carryOut(peel);
        QVERIFY(bench.coverage().at({20, 20, 29}) >= 128);
    }

    void doesNotGoThroughThePlate()
    {
        Bench bench({40, 40, 40});
        bench.fill([](const glm::dvec3& p) {
            return (p.z > -15.0 && p.z < -10.0) || p.z > 0.0 ? 1.0 : -1.0;
        });
        PeelCut peel = bench.peel(12.0, 25.0);
        (void)bench.carryOut(peel);
        QVERIFY(bench.coverage().at({20, 20, 7}) >= 128);
        QVERIFY(bench.coverage().at({20, 20, 22}) < 128);
        peel.throughGaps = true;
        bench.fill([&](const glm::dvec3& p) {
            return (p.z > -15.0 && p.z < -10.0) || p.z > 0.0 ? 1.0 : -1.0;
        });
        (void)bench.carryOut(peel);
        QVERIFY(bench.coverage().at({20, 20, 22}) >= 128);
    }

    void restores()
    {
        Bench bench({48, 48, 40});
        bench.fill([](const glm::dvec3& p) { return 18.0 - glm::length(p); });
        (void)bench.carryOut(bench.peel(12.0, 6.0));
        const auto carved = [&] {
            const Bytes cut = bench.coverage();
            int count = 0;
            for (std::size_t i = 0; i < cut.values.size(); ++i)
                count += cut.values[i] >= 128 && bench.codes.values[i] >= test::tissueCode / 2;
            return count;
        };
        const int all = carved();
        QVERIFY(all > 500);
        PeelCut back = bench.peel(12.0, 2.0);
        back.restore = true;
        (void)bench.carryOut(back);
        QVERIFY(carved() < 0.8 * all && carved() > 0.4 * all);
        back.depthMm = 20.0;
        (void)bench.carryOut(back);
        QVERIFY(carved() < 0.05 * all);
    }

    void scissorsCutWhatTheCurveSurrounds()
    {
        // Two plates; what the view does not see behind them too.
        const auto plates = [](const glm::dvec3& p) {
            return (p.z > -12.0 && p.z < -6.0) || (p.z > 2.0 && p.z < 14.0) ? 1.0 : -1.0;
        };
        const auto cutAt = [&](ScissorsCut cut, int z) {
            Bench bench({40, 40, 40});
            bench.fill(plates);
            (void)bench.carryOut(cut);
            return bench.coverage().at({20, 20, z}) >= 128;
        };
        Bench bench({40, 40, 40});
        ScissorsCut cut = bench.scissors(8.0);
        QVERIFY(cutAt(cut, 0) && cutAt(cut, 10) && cutAt(cut, 30) && cutAt(cut, 39));
        cut.firstLayerOnly = true;
        QVERIFY(cutAt(cut, 9) && cutAt(cut, 12) && !cutAt(cut, 23));
        cut.firstLayerOnly = false;
        cut.depthMm = 18.0; // from the first plate on, through the gap
        QVERIFY(cutAt(cut, 9) && cutAt(cut, 24) && !cutAt(cut, 29));
        cut.firstLayerOnly = true;
        cut.depthMm = 3.0;
        QVERIFY(cutAt(cut, 9) && !cutAt(cut, 12));

        bench.fill(plates);
        (void)bench.carryOut(bench.scissors(8.0));
        // Seen with +y up, right is −x: the outline is where it was drawn, to half a voxel.
        const Bytes carved = bench.coverage();
        for (int x = 0; x < 40; ++x) {
            const double mm = std::abs(x - 19.5);
            if (std::abs(mm - 8.0) >= 0.5)
                QCOMPARE(carved.at({x, 20, 10}) >= 128, mm < 8.0);
        }
        ScissorsCut back = bench.scissors(5.0);
        back.restore = true;
        (void)bench.carryOut(back);
        QVERIFY(bench.coverage().at({20, 20, 10}) < 128);
        QVERIFY(bench.coverage().at({26, 20, 10}) >= 128);
        back.polygonMm = Bench::square(20.0);
        (void)bench.carryOut(back);
        const Bytes none = bench.coverage();
        QVERIFY(std::all_of(none.values.begin(), none.values.end(), [](int v) { return v == 0; }));
    }

    void isReadAndRefused()
    {
        const auto read = [](const char* text) {
            return editFromJson(QJsonDocument::fromJson(
                QByteArray(text).replace('\'', '"').replace("VIEW",
                    "\"view\":{\"eyeLps\":[0,-200,0],\"targetLps\":[0,0,0],\"up\":[0,0,1],"
                    "\"heightMm\":80}"))
                                    .object());
        };
        const auto peel = read("{'edit':'peel',VIEW,'polygonMm':[[0,0],[9,0],[0,9]],'depthMm':3,"
                               "'surface':{'threshold':250}}");
        QVERIFY(peel);
        QCOMPARE(peel->get<PeelCut>().jumpMm, 4.0);
        QCOMPARE(editToJson(*editFromJson(editToJson(*peel))), editToJson(*peel));
        const auto scissors = read("{'edit':'scissors',VIEW,'polygonMm':[[0,0],[9,0],[0,9]],"
                                   "'surface':{'threshold':250}}");
        QVERIFY(scissors);
        QVERIFY(!scissors->get<ScissorsCut>().depthMm);
        for (const char* wrong :
            {"{'edit':'peel',VIEW,'polygonMm':[[0,0],[9,0]],'depthMm':3,'surface':{'threshold':1}}",
                "{'edit':'peel',VIEW,'depthMm':3,'surface':{'threshold':1}}",
                "{'edit':'peel',VIEW,'polygonMm':[[0,0],[9,0],[0,9]],'depthMm':-3,"
                "'surface':{'threshold':1}}",
                "{'edit':'scissors',VIEW,'polygonMm':[[0,0],[9,0],[0,9e9]],"
                "'surface':{'threshold':1}}"}) {
            const auto refused = read(wrong);
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, ErrorCode::InvalidField);
        }
        // Tiny, or without an area.
        Bench bench({20, 20, 20});
        for (const double half : {0.1, 0.0}) {
            const auto tiny = shellPeel(bench.peel(half, 1.0), bench.document);
            QVERIFY(!tiny);
            QCOMPARE(tiny.error().arguments.value(0), QStringLiteral("peel.polygonMm"));
        }
        ScissorsCut senseless = bench.scissors(5.0);
        senseless.restore = senseless.firstLayerOnly = true;
        QVERIFY(!outlineCut(senseless, bench.document));
        // Beside the volume there is nothing to cut.
        bench.fill([](const glm::dvec3&) { return 1.0; });
        PeelCut beside = bench.peel(5.0, 3.0);
        for (glm::dvec2& point : beside.polygonMm)
            point.x += 400.0;
        QVERIFY(bench.carryOut(beside).changes.empty());
    }
};

BURIN_TEST(ReferencePeelTest)

} // namespace referencePeelTest

#include "ReferencePeelTest.moc"
