// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicomweb/WebNode.h"
#include "core/pacs/PacsNode.h"
#include "core/pacs/PacsQuery.h"
#include "core/pacs/PacsSend.h"
#include "core/pacs/retrieve/PacsRetrieve.h"

#include <QJsonArray>
#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace core {

/// Where studies come from and masks go to, whatever it speaks: a DICOM node or a DICOMweb server.
struct PacsSource {
    QString name; ///< the user's own; may be empty
    std::variant<PacsNode, WebNode> node;
    std::optional<int> movePort; ///< of a DICOM node: it brings the objects there (C-MOVE)

    [[nodiscard]] bool isWeb() const { return std::holds_alternative<WebNode>(node); }
    /// "AETITLE@host:port" or "https://host/dicom-web"
    [[nodiscard]] QString address() const;
    /// Reads an address of either kind. InvalidField.
    [[nodiscard]] static Result<PacsSource> parse(const QString& address);
    /// InvalidField: what PacsNode or WebNode say, or a name that could be an address.
    [[nodiscard]] Result<void> check() const;
};

/// Without passwords and tokens, which are nowhere kept; entries that make no sense are left out.
[[nodiscard]] QJsonArray toJson(const std::vector<PacsSource>& sources);
[[nodiscard]] std::vector<PacsSource> sourcesFromJson(const QJsonArray& json);
/// By its name, whatever the case; null: none.
[[nodiscard]] const PacsSource* findSource(
    const std::vector<PacsSource>& sources, const QString& name);

/// What pacs/ and dicomweb/ do for their nodes, with their errors. These wait for the network; call
/// them on a worker's thread.
[[nodiscard]] Result<void> echoNode(const PacsSource& source, const Progress& progress);
[[nodiscard]] Result<HitList<StudyHit>> findStudies(
    const PacsSource& source, const StudyFilter& filter, int most, const Progress& progress);
[[nodiscard]] Result<std::vector<SeriesHit>> findSeries(
    const PacsSource& source, const QString& studyUid, const Progress& progress);
[[nodiscard]] Result<Retrieved> retrieve(const PacsSource& source, const RetrieveWish& wish,
    const QString& target, const Progress& progress);
[[nodiscard]] Result<SentObjects> sendFiles(
    const PacsSource& source, const QStringList& files, const Progress& progress);

/// Fetches the object in the middle of a series, by the numbers of its objects, into the folder
/// @p target. @return what it is called there. NodeHasNone: the source lists no objects.
[[nodiscard]] Result<QString> retrieveMiddle(const PacsSource& source, const SeriesHit& series,
    const QString& target, const Progress& progress);

} // namespace core
