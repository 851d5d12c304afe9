// SPDX-License-Identifier: Apache-2.0
#include "app/steps/ExportFiles.h"

#include "app/steps/JsonLine.h"
#include "app/steps/SteadySession.h"
#include "core/export/CarvedVolume.h"
#include "core/export/common/ExportChoices.h"
#include "core/export/common/ImportedSegments.h"
#include "core/session/past/PastImports.h"
#include "core/session/past/SegmentLayers.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/texts/ReportTexts.h"

#include <QUuid>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

namespace app {

using core::Result;

namespace {

/// Writes one after the other; what more than one of them needs is read once.
class Exports {
public:
    Exports(SteadySession& session, bool force, const ReadStudy& readStudy,
        const core::Progress& progress)
        : m_steady(session)
        , m_volume(session.session().document().volumes.front())
        , m_force(force)
        , m_readStudy(readStudy)
        , m_progress(progress)
    {
    }

    Result<core::ExportReport> write(const core::RecipeExport& target)
    {
        switch (target.what) {
        case core::RecipeExport::What::Coverage:
            return coverage(target);
        case core::RecipeExport::What::CarvedVolume:
            return carvedVolume(target);
        case core::RecipeExport::What::Segments:
            break;
        }
        return segments(target);
    }

private:
    Result<core::ExportReport> segments(const core::RecipeExport& target)
    {
        core::ExportRequest request;
        for (const std::uint8_t plane : document().labelPlanes()) {
            if (const Result<void> known = readLabels(plane); !known)
                return tl::unexpected(known.error());
            request.planes.push_back({.plane = plane, .labels = m_labels[plane]});
        }
        request.format = target.format;
        request.file = target.file;
        request.force = m_force;
        request.space = target.space;
        request.seg = target.seg;
        request.deidentifier = deidentifier(target);
        QStringList hidden;
        for (const core::ExportChoice& choice : core::exportChoices(document(), {})) {
            if (choice.chosen)
                request.segments.push_back(choice.segment);
            else if (choice.segment.voxels > 0)
                hidden += choice.segment.name;
        }
        if (request.segments.empty())
            return core::failure(core::ErrorCode::NothingToExport, target.file,
                QStringLiteral("no segment that is shown has a voxel"));
        // A session goes on as the window left it, where nobody may have thought of files.
        if (!hidden.isEmpty())
            std::fprintf(stderr, "%s: left out, as the session hides them: %s\n",
                qUtf8Printable(target.file), qUtf8Printable(hidden.join(QStringLiteral(", "))));
        if (const Result<void> coded = addCodes(request, target); !coded)
            return tl::unexpected(coded.error());
        if (core::factsOf(target.format).isStatistics) {
            if (const Result<void> read = readValues(); !read)
                return tl::unexpected(read.error());
            request.codes = m_study->codes;
            request.measurements = document().measurements;
            request.imported = core::importedAs(document().segments,
                core::doneImports(m_steady.session().history()), m_volume.geometry.voxelCount());
        }
        if (target.format == core::ExportFormat::DicomSegFractional) {
            if (const Result<void> added = addCoverages(request); !added)
                return tl::unexpected(added.error());
        }
        return core::exportMask(m_volume, request, m_progress);
    }

    /// One mapping for all exports of a run that ask for the same.
    std::shared_ptr<const core::Deidentifier> deidentifier(const core::RecipeExport& target)
    {
        if (!target.deidentify)
            return {};
        return std::make_shared<core::Deidentifier>(*target.deidentify, m_volume.identity,
            target.secret.isEmpty() ? m_secret : target.secret);
    }

    static Result<void> addCodes(core::ExportRequest& request, const core::RecipeExport& target)
    {
        for (const auto& [name, codes] : target.codes) {
            bool isThere = false;
            // Names are not unique.
            for (const core::Segment& segment : request.segments) {
                if (segment.name != name)
                    continue;
                request.seg.codes[segment.label] = codes;
                isThere = true;
            }
            if (!isThere)
                return core::failure(core::ErrorCode::UnsupportedFormat, target.file,
                    QStringLiteral(
                        "it has codes for a segment '%1', and no such segment is exported")
                        .arg(name));
        }
        return {};
    }

    Result<void> readLabels(std::uint8_t plane)
    {
        if (m_labels.contains(plane))
            return {};
        Result<std::vector<std::uint8_t>> labels =
            read([plane](core::EditSession& session) { return session.questions().labels(plane); });
        if (!labels)
            return tl::unexpected(labels.error());
        m_labels[plane] = *std::move(labels);
        return {};
    }

    /// The engine has the values; the study's files are where they can be had from exactly.
    Result<void> readValues()
    {
        if (m_study)
            return {};
        Result<core::LoadedVolume> study = m_readStudy();
        if (!study)
            return tl::unexpected(study.error());
        m_study = *std::move(study);
        return {};
    }

    /// Of the layers that the segments were made of.
    Result<void> addCoverages(core::ExportRequest& request)
    {
        const auto layers = core::layersOfSegments(m_steady.session().history(), document());
        for (const auto& [label, id] : layers) {
            if (!m_coverages.contains(id)) {
                Result<std::vector<std::uint8_t>> bytes = coverageOf(id);
                if (!bytes)
                    return tl::unexpected(bytes.error());
                m_coverages[id] = *std::move(bytes);
            }
            request.coverages.push_back({.label = std::uint8_t(label),
                .layer = document().layer(id)->name,
                .coverage = m_coverages[id]});
        }
        return {};
    }

    Result<core::ExportReport> coverage(const core::RecipeExport& target)
    {
        const core::SculptLayer* layer = document().layer(target.layer);
        if (!layer)
            return core::failure(core::ErrorCode::NothingToExport, target.file,
                QStringLiteral("there is no sculpt layer %1").arg(target.layer));
        const QString name = layer->name;
        const Result<std::vector<std::uint8_t>> bytes = coverageOf(layer->id);
        if (!bytes)
            return tl::unexpected(bytes.error());
        return core::exportCoverage(m_volume,
            {.file = target.file, .force = m_force, .layer = name, .coverage = *bytes}, m_progress);
    }

    Result<core::ExportReport> carvedVolume(const core::RecipeExport& target)
    {
        std::vector<std::uint8_t> carved(m_volume.geometry.voxelCount(), 0);
        std::vector<int> carving;
        for (const core::SculptLayer& layer : document().layers) {
            if (document().carves(layer))
                carving.push_back(layer.id);
        }
        for (const int layer : carving) {
            const Result<std::vector<std::uint8_t>> bytes = coverageOf(layer);
            if (!bytes)
                return tl::unexpected(bytes.error());
            std::transform(carved.begin(), carved.end(), bytes->begin(), carved.begin(),
                [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
        }
        if (const Result<void> read = readValues(); !read)
            return tl::unexpected(read.error());
        return core::exportCarvedVolume(m_study->volume,
            {.target = target.file,
                .force = m_force,
                .coverage = carved,
                .codes = m_study->codes,
                .fill = target.fill,
                .deidentifier = deidentifier(target)},
            m_progress);
    }

    /// What the engine holds of the session, be it another engine in the end.
    template <class Question> Result<std::vector<std::uint8_t>> read(const Question& question)
    {
        std::vector<std::uint8_t> answer;
        const Result<void> done = m_steady.carryOut([&]() -> Result<void> {
            Result<std::vector<std::uint8_t>> bytes = question(m_steady.session());
            if (!bytes)
                return tl::unexpected(bytes.error());
            answer = *std::move(bytes);
            return {};
        });
        if (!done)
            return tl::unexpected(done.error());
        return answer;
    }

    Result<std::vector<std::uint8_t>> coverageOf(int layer)
    {
        return read([layer](core::EditSession& session) {
            return session.questions().coverage(std::uint8_t(layer));
        });
    }

    /// Until something is read.
    [[nodiscard]] const core::Document& document() const { return m_steady.session().document(); }

    SteadySession& m_steady;
    core::Volume m_volume;
    bool m_force = false;
    const ReadStudy& m_readStudy;
    const core::Progress& m_progress;
    std::map<std::uint8_t, std::vector<std::uint8_t>> m_labels; ///< by plane
    std::map<int, std::vector<std::uint8_t>> m_coverages; ///< by layer
    std::optional<core::LoadedVolume> m_study;
    QByteArray m_secret =
        QUuid::createUuid().toRfc4122() + QUuid::createUuid().toRfc4122(); ///< of this run
};

} // namespace

Result<void> withoutForce(const Result<void>& checked)
{
    if (checked || checked.error().code != core::ErrorCode::FileExists)
        return checked;
    return core::failure(core::ErrorCode::FileUnwritable, checked.error().arguments.value(0),
        QStringLiteral("it exists already, and a session that goes on replaces no file; give the "
                       "export another name"));
}

Result<void> exportFiles(const std::vector<core::RecipeExport>& targets, SteadySession& session,
    bool force, const ReadStudy& readStudy, const core::Progress& progress)
{
    Exports exports(session, force, readStudy, progress);
    for (const core::RecipeExport& target : targets) {
        if (progress.cancelled())
            return core::failure(core::ErrorCode::Cancelled);
        const Result<core::ExportReport> report = exports.write(target);
        if (!report)
            return tl::unexpected(report.error());
        const auto list = [](const core::ReportLines& lines) {
            return QJsonValue(ui::reportTexts(lines).join(QStringLiteral(" ")));
        };
        QJsonObject line{
            {QStringLiteral("export"), report->file},
            {QStringLiteral("written"), list(report->written)},
            {QStringLiteral("checked"), list(report->checked)},
            {QStringLiteral("cautions"), list(report->cautions)},
        };
        if (!report->sha256.isEmpty())
            line[QStringLiteral("sha256")] = report->sha256;
        printJsonLine(line);
    }
    return {};
}

} // namespace app
