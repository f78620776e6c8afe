# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
