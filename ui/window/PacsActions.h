// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Adds "From PACS …" and "Send to PACS …" to the File menu, and protects the local copy of the
/// open study.
void addPacsActions(MainWindow& window);

} // namespace ui
