"""How good the choices of ``shadercache tune`` are: models, search and bounds, measured."""
