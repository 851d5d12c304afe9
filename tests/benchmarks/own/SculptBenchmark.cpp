// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/SculptBenchmark.h"

#include "core/demo/DemoStudy.h"
#include "core/document/Piece.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "gpu/engine/EditTransaction.h"
#include "gpu/gl/Gl.h"
#include "gpu/gl/context/EglContext.h"
#include "gpu/shaders/ShaderLibrary.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/common/RowTimes.h"
#include "tests/support/scenes/SculptStage.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

namespace bench {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int rounds = 9;

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double milliseconds(const std::function<void()>& work)
{
    const Clock::time_point start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// --- Masks ---------------------------------------------------------------------------------------

/// A wavy closed curve that crosses itself, in elements.
std::vector<glm::dvec2> lasso()
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 2000; ++i) {
        const double t = 2.0 * std::numbers::pi * i / 2000.0;
        const double r = 0.8 + 0.15 * std::sin(23.0 * t) + 0.05 * std::sin(311.0 * t);
        points.emplace_back(615.0 + 610.0 * r * std::cos(t),
            435.0 + 430.0 * r * std::sin(t + 0.4 * std::sin(3 * t)));
    }
    return points;
}

QString measureLasso(PeerReport& report)
{
    const std::vector<glm::dvec2> points = lasso();
    std::vector<core::OutlineVertex> vertices;
    QPolygonF polygon;
    for (const glm::dvec2& point : points) {
        vertices.emplace_back(glm::round(point * double(core::outlineSubdivision)));
        polygon << QPointF(vertices.back().x, vertices.back().y) / core::outlineSubdivision;
    }
    core::OutlineRaster ours;
    core::OutlineRaster filtered;
    QImage theirs(1230, 870, QImage::Format_Grayscale8);
    std::vector<double> oursMs;
    std::vector<double> filteredMs;
    std::vector<double> theirsMs;
    for (int round = 0; round < rounds; ++round) {
        oursMs.push_back(milliseconds([&] { ours = core::filledExactly(vertices); }));
        filteredMs.push_back(
            oursMs.back() + milliseconds([&] { filtered = core::smoothed(ours); }));
        theirsMs.push_back(milliseconds([&] {
            theirs.fill(Qt::black);
            QPainter painter(&theirs);
            painter.setRenderHint(QPainter::Antialiasing);
            QPainterPath path;
            path.addPolygon(polygon);
            path.closeSubpath();
            path.setFillRule(Qt::WindingFill);
            painter.fillPath(path, Qt::white);
        }));
    }
    double difference = 0.0;
    for (int y = 0; y < theirs.height(); ++y) {
        for (int x = 0; x < theirs.width(); ++x)
            difference += std::abs(ours.at({x, y}) / 256.0 - theirs.constScanLine(y)[x] / 255.0);
    }
    const double area = double(ours.area()) / 256.0;
    std::fprintf(
        stderr, "mask.lasso: %.0f elements, differs from Qt by %.1f of them\n", area, difference);
    if (difference > 0.002 * area)
        return QStringLiteral("mask.lasso: the fill differs from Qt's");
    report.add({"mask.lasso.fill", "Ms", median(oursMs), "Qt raster", median(theirsMs)});
    report.add({"mask.lasso", "Ms", median(filteredMs)});
    return {};
}

// --- Strokes -------------------------------------------------------------------------------------

constexpr double airCode = 100.0;

/// A cube of 1 mm voxels, material from a gently waved surface in the middle on.
class Block {
public:
    Block(const gpu::ShaderLibrary& shaders, int side)
        : m_side(side)
        , m_cells(shaders, {.label = "macro-cells", .path = "fields/textures/macroCells.comp"})
        , m_programs(shaders)
        , m_fieldPrograms(shaders)
        , m_radiation(m_fieldPrograms.radiation, {glm::ivec3(side)})
    {
        std::vector<std::uint16_t> codes(std::size_t(side) * side * side);
        for (int k = 0; k < side; ++k) {
            for (int j = 0; j < side; ++j) {
                for (int i = 0; i < side; ++i) {
                    const double surface = side / 2.0
                        + 3.0 * std::sin(0.11 * (i - side / 2)) * std::cos(0.09 * (j - side / 2));
                    codes[std::size_t(i)
                        + std::size_t(side)
                            * (std::size_t(j) + std::size_t(side) * std::size_t(k))] =
                        std::uint16_t(std::clamp(1000.0 + 600.0 * (k - surface), airCode, 2000.0));
                }
            }
        }
        m_opened = bool(m_textures.open(glm::ivec3(side), codes));
        if (!m_opened)
            return;
        core::Volume volume;
        volume.geometry.size = glm::ivec3(side);
        volume.geometry.indexToWorld = glm::dmat4(1.0);
        volume.encoding.rescaleSlope = 1.0;
        m_document.volumes.push_back(volume);
        m_document.layers.push_back({.id = 1, .name = QStringLiteral("Sculpt 1")});
        m_fields = std::make_unique<gpu::VoxelFields>(m_fieldPrograms, m_textures);
    }
    [[nodiscard]] bool isOpen() const { return m_opened; }

    [[nodiscard]] core::OrthographicView view() const
    {
        const glm::dvec3 middle(m_side / 2.0);
        return {.eyeLps = middle - glm::dvec3(0.0, 0.0, 400.0),
            .targetLps = middle,
            .up = {0.0, -1.0, 0.0},
            .heightMm = 200.0};
    }
    [[nodiscard]] const core::Document& document() const { return m_document; }

    struct Cost {
        std::vector<double> tickMs; ///< cut and radiation
        std::vector<double> cellsMs; ///< and then the macro-cells
        [[nodiscard]] double pictureMs() const { return median(tickMs) + median(cellsMs); }
    };
    /// One edit, tick by tick; taken back at the end.
    Cost ticks(const core::EngineEdit& edit, const std::vector<core::EngineExtension>& extensions,
        bool compare = false)
    {
        Cost cost;
        auto transaction = gpu::EditTransaction::begin(m_programs, *m_fields, edit);
        if (!transaction)
            return cost;
        for (const core::EngineExtension& extension : extensions) {
            cost.tickMs.push_back(milliseconds([&] {
                static_cast<void>((*transaction)->extend(extension));
                glFinish();
            }));
            cost.cellsMs.push_back(milliseconds([&] {
                updateCells(m_textures.takeDirty(gpu::VolumeField::Radiation));
                glFinish();
            }));
        }
        if (compare)
            compareWithWhole();
        core::EngineResult result;
        (*transaction)->rollBack(result);
        updateCells(m_textures.takeDirty(gpu::VolumeField::Radiation));
        return cost;
    }

    // After ticks(…, true):
    [[nodiscard]] bool isEqual() const { return m_equal; }
    [[nodiscard]] std::size_t carvedVoxels() const { return m_carved; }
    [[nodiscard]] double wholeMs() const { return m_wholeMs; }

private:
    void updateCells(const core::VoxelBox& box)
    {
        m_textures.cells().update(m_cells, m_textures.radiation(), m_textures.segmentation(), box);
    }
    [[nodiscard]] std::vector<std::byte> bytesOf(
        const gpu::Texture3D& texture, std::size_t texel) const
    {
        const glm::ivec3 size = texture.size();
        std::vector<std::byte> bytes(std::size_t(size.x) * size.y * size.z * texel);
        texture.read(glm::ivec3(0), size, bytes);
        return bytes;
    }
    /// Works out all that follows from the coverage for the whole volume, and times it.
    void compareWithWhole()
    {
        const gpu::VisibleCodes visible{.intervals = {{1000, 65535}}};
        const std::vector<std::byte> before = bytesOf(m_fields->radiation(), 1);
        const std::vector<std::byte> skipBefore = bytesOf(m_textures.cells().skipMap(visible), 2);
        m_carved = std::size_t(std::count_if(before.begin(), before.end(),
            [](std::byte radiation) { return std::to_integer<int>(radiation) >= 128; }));
        std::vector<gpu::RadiationKernel::Region> everywhere;
        for (int brick = 0; brick < m_fields->grid().brickCount(); ++brick)
            everywhere.push_back({.brick = std::uint32_t(brick)});
        gpu::BrickField* const coverage = &m_fields->coverage(1);
        std::vector<double> times;
        for (int round = 0; round < 3; ++round) {
            times.push_back(milliseconds([&] {
                m_radiation.updateFromCoverage({&coverage, 1}, m_fields->radiation(), everywhere);
                updateCells({.minimum = glm::ivec3(0), .maximum = glm::ivec3(m_side)});
                glFinish();
            }));
        }
        m_wholeMs = median(times);
        m_equal = before == bytesOf(m_fields->radiation(), 1)
            && skipBefore == bytesOf(m_textures.cells().skipMap(visible), 2);
    }

    int m_side;
    bool m_opened = false;
    gpu::VolumeTextures m_textures;
    gpu::Program m_cells;
    gpu::EditPrograms m_programs;
    gpu::FieldPrograms m_fieldPrograms;
    gpu::RadiationKernel m_radiation;
    core::Document m_document;
    std::unique_ptr<gpu::VoxelFields> m_fields;
    std::size_t m_carved = 0;
    double m_wholeMs = 0.0;
    bool m_equal = false;
};

/// An edit and what the pen reports, 120 times a second.
struct Stroke {
    const char* id;
    core::EngineEdit edit;
    std::vector<core::EngineExtension> ticks;
};

std::vector<Stroke> strokes(const Block& block)
{
    std::vector<Stroke> result;
    core::DrillStroke drill;
    drill.view = block.view();
    drill.mask.radiusMm = 8.0;
    drill.surfaceThreshold = 1000.0;
    drill.byTime = true;
    if (const auto cut = core::drillCut(drill, block.document())) {
        core::DrillPathSampler sampler(drill, *cut);
        Stroke stroke{"sculpt.drill", *cut, {}};
        for (int tick = 0; tick < 60; ++tick) {
            const auto samples = sampler.add({{.xMm = 0.5 * tick - 15.0,
                .yMm = 6.0 * std::sin(0.1 * tick),
                .pressure = 0.7 + 0.3 * std::sin(0.2 * tick),
                .tSeconds = tick / 120.0}});
            stroke.ticks.push_back(core::DrillPath{samples});
        }
        result.push_back(std::move(stroke));
    }
    core::LaserStroke laser;
    laser.view = drill.view;
    laser.mask = drill.mask;
    laser.depthMm = drill.depthMm;
    laser.surfaceThreshold = drill.surfaceThreshold;
    if (const auto cut = core::laserCut(laser, block.document())) {
        Stroke stroke{"sculpt.laser", *cut, {}};
        for (int tick = 0; tick < 30; ++tick) {
            laser.samples = {{.xMm = 0.5 * tick - 7.0,
                .yMm = 6.0 * std::sin(0.1 * tick),
                .pressure = 0.7 + 0.3 * std::sin(0.2 * tick)}};
            stroke.ticks.push_back(core::DrillPath{core::laserPath(laser, *cut)});
        }
        result.push_back(std::move(stroke));
    }
    core::PeelCut peel;
    peel.view = block.view();
    peel.surfaceThreshold = 1000.0;
    for (int i = 0; i < 60; ++i) {
        const double t = 2.0 * std::numbers::pi * i / 60.0;
        peel.polygonMm.emplace_back(25.0 * std::cos(t), 20.0 * std::sin(t));
    }
    if (const auto cut = core::shellPeel(peel, block.document())) {
        Stroke stroke{"sculpt.peel", *cut, {}};
        for (int tick = 1; tick <= 20; ++tick) {
            peel.depthMm = 0.5 * tick;
            stroke.ticks.push_back(core::peelDepth(peel));
        }
        result.push_back(std::move(stroke));
    }
    return result;
}

/// Ticks in volumes of three sizes by turns, so that what else the machine does meets all alike.
QString measureStrokesHere(PeerReport& report)
{
    const gpu::ShaderLibrary shaders = gpu::ShaderLibrary::builtIn();
    constexpr std::array sides{128, 256, 512};
    std::array<std::unique_ptr<Block>, sides.size()> blocks;
    std::array<std::vector<Stroke>, sides.size()> strokesIn;
    for (std::size_t size = 0; size < sides.size(); ++size) {
        blocks[size] = std::make_unique<Block>(shaders, sides[size]);
        if (!blocks[size]->isOpen())
            return QStringLiteral("sculpt: no room for %1 voxels cubed").arg(sides[size]);
        strokesIn[size] = strokes(*blocks[size]);
    }
    for (std::size_t number = 0; number < strokesIn[0].size(); ++number) {
        const std::string id = strokesIn[0][number].id;
        std::array<std::vector<double>, sides.size()> pictures;
        std::array<std::vector<double>, sides.size()> cells;
        std::array<std::vector<double>, sides.size()> ratios; // to the smallest
        for (std::size_t size = 0; size < sides.size(); ++size) {
            // The first pass compiles and makes the pages; it is compared instead of timed.
            const Stroke& stroke = strokesIn[size][number];
            static_cast<void>(blocks[size]->ticks(stroke.edit, stroke.ticks, true));
            if (!blocks[size]->isEqual() || blocks[size]->carvedVoxels() == 0)
                return QStringLiteral("%1: %2 voxels cubed: not as worked out anew")
                    .arg(QLatin1String(stroke.id))
                    .arg(sides[size]);
            if (blocks[size]->carvedVoxels() != blocks[0]->carvedVoxels())
                return QStringLiteral("%1: cuts %2 voxels of %3 cubed, not %4")
                    .arg(QLatin1String(stroke.id))
                    .arg(blocks[size]->carvedVoxels())
                    .arg(sides[size])
                    .arg(blocks[0]->carvedVoxels());
        }
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t size = 0; size < sides.size(); ++size) {
                const Stroke& stroke = strokesIn[size][number];
                const Block::Cost cost = blocks[size]->ticks(stroke.edit, stroke.ticks);
                pictures[size].push_back(cost.pictureMs());
                cells[size].push_back(median(cost.cellsMs));
                ratios[size].push_back(pictures[0].back() / pictures[size].back());
            }
        }
        for (std::size_t size = 0; size < sides.size(); ++size) {
            const std::string place = "." + std::to_string(sides[size]);
            const double tick = median(pictures[size]);
            report.add({id + place, "Ms", tick, "whole volume", blocks[size]->wholeMs()});
            report.add({id + ".cells" + place, "Ms", median(cells[size])});
            if (size > 0)
                report.add({id + place, "Ms", tick, "128 cubed", tick * median(ratios[size])});
        }
    }
    return {};
}

QString measureStrokes(PeerReport& report)
{
    auto context = gpu::EglContext::create();
    if (!context || !(*context)->makeCurrent())
        return QStringLiteral("sculpt: no GL context");
    const QString why = measureStrokesHere(report);
    (*context)->doneCurrent();
    return why;
}

// --- Pictures ------------------------------------------------------------------------------------

core::LoadedVolume demoHead(const core::DemoStudy& demo)
{
    core::LoadedVolume study;
    study.volume.geometry = demo.geometry;
    study.volume.encoding.rescaleIntercept = -1024.0;
    study.volume.unit = QStringLiteral("HU");
    for (const std::int16_t hounsfield : demo.hounsfield)
        study.codes.push_back(std::uint16_t(hounsfield + 1024));
    return study;
}

/// Before and after the vault of the skull is taken off, and with four pieces of it laid aside.
QString measurePictures(PeerReport& report)
{
    const auto demo = core::makeDemoStudy({});
    if (!demo)
        return QStringLiteral("frame: no demonstration study");
    test::SculptStage stage(demoHead(*demo));
    if (!stage.isReady())
        return QStringLiteral("frame: no engine");
    gpu::VolumeScene surface;
    surface.eyeLps = {-260.0, -430.0, 210.0};
    surface.heightMm = 240.0;
    surface.surfaceThreshold = 200.0;
    gpu::VolumeScene dvr = surface;
    dvr.mode = gpu::RenderMode::Dvr;
    dvr.transferFunction.points = {{150.0, 0x8a4b32, 0.0}, {250.0, 0xd9a066, 0.05},
        {600.0, 0xf2e4c4, 0.35}, {1800.0, 0xffffff, 0.8}};
    gpu::VolumeScene mip = surface;
    mip.mode = gpu::RenderMode::Mip;
    mip.mipWindow = {.centre = 700.0, .width = 1800.0};
    const auto time = [&](const gpu::VolumeScene& scene, const char* id = nullptr) {
        std::vector<double> times;
        for (int round = 0; round < rounds; ++round) {
            times.push_back(stage.fullFrameMs(scene, {1230, 870}));
            if (id)
                RowTimes::ended(id, times.back());
        }
        if (id)
            RowTimes::moves(id, 3.0 * double(demo->geometry.voxelCount()) + 8.0 * 1230 * 870,
                "each voxel's value and coverage read, each pixel written and fetched");
        return median(times);
    };
    const double surfaceBefore = time(surface);
    const double dvrBefore = time(dvr);
    const double mipBefore = time(mip);

    core::PeelCut peel;
    peel.view = {.eyeLps = surface.eyeLps, .targetLps = {}, .up = {0, 0, 1}, .heightMm = 240.0};
    peel.surfaceThreshold = surface.surfaceThreshold;
    peel.depthMm = 8.0;
    std::vector<std::uint8_t> carved;
    for (int quarter = 0; quarter < 4; ++quarter) {
        if (quarter > 0
            && !stage.apply(core::AddLayer{.name = QStringLiteral("Quarter")}).isEmpty())
            return QStringLiteral("frame: no layer");
        peel.layer = quarter + 1;
        const glm::dvec2 corner(quarter % 2 == 0 ? -36.0 : 2.0, quarter / 2 == 0 ? 26.0 : 62.0);
        peel.polygonMm = {corner, corner + glm::dvec2(34.0, 0.0), corner + glm::dvec2(34.0, 32.0),
            corner + glm::dvec2(0.0, 32.0)};
        if (const QString why = stage.apply(peel); !why.isEmpty())
            return QStringLiteral("frame: the skull was not peeled: ") + why;
    }
    report.add({"frame.surface.opened", "Ms", time(surface, "frame.surface.opened"),
        "before the cut", surfaceBefore});
    report.add(
        {"frame.dvr.opened", "Ms", time(dvr, "frame.dvr.opened"), "before the cut", dvrBefore});
    report.add(
        {"frame.mip.opened", "Ms", time(mip, "frame.mip.opened"), "before the cut", mipBefore});
    const double surfaceOpened = time(surface);
    const double dvrOpened = time(dvr);
    const double mipOpened = time(mip);
    for (int piece = 1; piece <= 4; ++piece) {
        for (const core::Edit& edit :
            {core::Edit(core::CutPiece{.layer = piece, .name = QStringLiteral("Quarter")}),
                core::Edit(core::ChangePiece{
                    .piece = piece, .offsetMm = glm::dvec3(30.0 * piece - 75.0, -30.0, 40.0)})}) {
            if (const QString why = stage.apply(edit); !why.isEmpty())
                return QStringLiteral("frame: no piece: ") + why;
        }
    }
    for (const core::Piece& piece : stage.session().document().pieces) {
        const gpu::ScenePiece shown{.id = piece.id,
            .layer = piece.layer,
            .shownFromTrue = core::shownFromTrue(piece, demo->geometry)};
        surface.pieces.push_back(shown);
        dvr.pieces.push_back(shown);
        mip.pieces.push_back(shown);
    }
    report.add({"frame.surface.pieces", "Ms", time(surface, "frame.surface.pieces"), "no pieces",
        surfaceOpened});
    report.add({"frame.dvr.pieces", "Ms", time(dvr, "frame.dvr.pieces"), "no pieces", dvrOpened});
    report.add({"frame.mip.pieces", "Ms", time(mip, "frame.mip.pieces"), "no pieces", mipOpened});
    return {};
}

} // namespace

QString measureSculpting(PeerReport& report)
{
    for (const auto measure : {measureLasso, measureStrokes, measurePictures}) {
        if (const QString why = measure(report); !why.isEmpty())
            return why;
    }
    return {};
}

} // namespace bench
