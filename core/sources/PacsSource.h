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

/// A server from which studies are retrieved and to which masks are sent: a DICOM node or a
/// DICOMweb server.
struct PacsSource {
    QString name; ///< chosen by the user; may be empty
    std::variant<PacsNode, WebNode> node;
    std::optional<int> movePort; ///< for a DICOM node: the port to which it sends objects (C-MOVE)

    [[nodiscard]] bool isWeb() const { return std::holds_alternative<WebNode>(node); }
    /// "AETITLE@host:port" or "https://host/dicom-web"
    [[nodiscard]] QString address() const;
    /// Parses an address of either kind. Errors: InvalidField.
    [[nodiscard]] static Result<PacsSource> parse(const QString& address);
    /// Errors: InvalidField (those of PacsNode and WebNode, or a name that could be an address).
    [[nodiscard]] Result<void> check() const;
};

/// Without passwords and tokens, which are never stored. Invalid entries are left out when reading,
/// except those that only lack a file for TLS: they are kept to be completed, and refused when
/// used.
[[nodiscard]] QJsonArray toJson(const std::vector<PacsSource>& sources);
[[nodiscard]] std::vector<PacsSource> sourcesFromJson(const QJsonArray& json);
/// Finds a source by its name, ignoring case; null if there is none.
[[nodiscard]] const PacsSource* findSource(
    const std::vector<PacsSource>& sources, const QString& name);

/// The functions of pacs/ and dicomweb/ for either kind of node, with their errors. They block;
/// call them on a worker thread.
[[nodiscard]] Result<void> echoNode(const PacsSource& source, const Progress& progress);
[[nodiscard]] Result<HitList<StudyHit>> findStudies(
    const PacsSource& source, const StudyFilter& filter, int most, const Progress& progress);
[[nodiscard]] Result<std::vector<SeriesHit>> findSeries(
    const PacsSource& source, const QString& studyUid, const Progress& progress);
[[nodiscard]] Result<Retrieved> retrieve(const PacsSource& source, const RetrieveWish& wish,
    const QString& target, const Progress& progress);
[[nodiscard]] Result<SentObjects> sendFiles(
    const PacsSource& source, const QStringList& files, const Progress& progress);

/// Retrieves the object in the middle of a series, by instance number, into the folder @p target.
/// @return its file name there. Errors also: NodeHasNone (the source lists no objects).
[[nodiscard]] Result<QString> retrieveMiddle(const PacsSource& source, const SeriesHit& series,
    const QString& target, const Progress& progress);

} // namespace core
