// SPDX-License-Identifier: Apache-2.0
#include "app/ExportFiles.h"

#include "app/JsonLine.h"
#include "core/export/CarvedVolume.h"
#include "core/export/ExportChoices.h"

#include <algorithm>

namespace app {

using core::Result;

namespace {

/// Writes one after the other; what more than one of them needs is read once.
class Exports {
public:
    Exports(core::EditSession& session, bool force, const ReadStudy& readStudy)
        : m_session(session)
        , m_volume(session.document().volumes.front())
        , m_force(force)
        , m_readStudy(readStudy)
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
        if (m_labels.empty()) {
            Result<std::vector<std::uint8_t>> labels = m_session.labels(0);
            if (!labels)
                return tl::unexpected(labels.error());
            m_labels = *std::move(labels);
        }
        core::ExportRequest request;
        request.format = target.format;
        request.file = target.file;
        request.force = m_force;
        request.space = target.space;
        request.planes = {{.plane = 0, .labels = m_labels}};
        for (const core::ExportChoice& choice : core::exportChoices(m_session.document(), {})) {
            if (choice.chosen)
                request.segments.push_back(choice.segment);
        }
        return core::exportMask(m_volume, request, core::Progress());
    }

    Result<core::ExportReport> coverage(const core::RecipeExport& target)
    {
        const core::SculptLayer* layer = m_session.document().layer(target.layer);
        if (!layer)
            return core::failure(core::ErrorCode::InvalidField, QStringLiteral("export.layer"),
                QStringLiteral("there is no sculpt layer %1").arg(target.layer));
        const Result<std::vector<std::uint8_t>> bytes = m_session.coverage(layer->id);
        if (!bytes)
            return tl::unexpected(bytes.error());
        return core::exportCoverage(m_volume,
            {.file = target.file, .force = m_force, .layer = layer->name, .coverage = *bytes},
            core::Progress());
    }

    Result<core::ExportReport> carvedVolume(const core::RecipeExport& target)
    {
        std::vector<std::uint8_t> carved(m_volume.geometry.voxelCount(), 0);
        for (const core::SculptLayer& layer : m_session.document().layers) {
            if (!m_session.document().carves(layer))
                continue;
            const Result<std::vector<std::uint8_t>> bytes = m_session.coverage(layer.id);
            if (!bytes)
                return tl::unexpected(bytes.error());
            std::transform(carved.begin(), carved.end(), bytes->begin(), carved.begin(),
                [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
        }
        // The engine has the values; the study's files are where they can be had from exactly.
        const Result<core::LoadedVolume> study = m_readStudy();
        if (!study)
            return tl::unexpected(study.error());
        return core::exportCarvedVolume(study->volume,
            {.target = target.file,
                .force = m_force,
                .coverage = carved,
                .codes = study->codes,
                .fill = target.fill},
            core::Progress());
    }

    core::EditSession& m_session;
    const core::Volume& m_volume;
    bool m_force = false;
    const ReadStudy& m_readStudy;
    std::vector<std::uint8_t> m_labels;
};

} // namespace

Result<void> exportFiles(const std::vector<core::RecipeExport>& targets, core::EditSession& session,
    bool force, const ReadStudy& readStudy)
{
    Exports exports(session, force, readStudy);
    for (const core::RecipeExport& target : targets) {
        const Result<core::ExportReport> report = exports.write(target);
        if (!report)
            return tl::unexpected(report.error());
        const auto list = [](const QStringList& sentences) {
            return QJsonValue(sentences.join(QStringLiteral(" ")));
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
