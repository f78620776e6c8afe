from typing import Any, TypedDict
