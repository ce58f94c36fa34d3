"""The types that editors read are those of the package."""

import ast
import inspect
import pathlib

import naocal

STUB = ast.parse((pathlib.Path(naocal.__file__).parent / "__init__.pyi").read_text())


def test_classes_have_the_members_of_the_stub():
    """Proves that stub and package name the same classes with the same members, and that each has a docstring."""
    stubs = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
    classes = {name: each for name, each in vars(naocal).items() if inspect.isclass(each)}
    assert stubs.keys() == classes.keys()
    for name, node in stubs.items():
        assert classes[name].__doc__, name
        stated = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
        ignored = {"__init__", "__repr__", "__module__", "__doc__", "__new__", "__weakref__"}
        present = {member for member in vars(classes[name]) if not member.startswith("_pybind11")} - ignored
        assert stated == present, name


def test_functions_have_the_signatures_of_the_stub():
    """Proves that names, order, kinds and defaults of all arguments agree, and that docstrings name each argument."""
    stubs = {node.name: node for node in STUB.body if isinstance(node, ast.FunctionDef)}
    functions = {name: each for name, each in vars(naocal).items()
                 if inspect.isfunction(each) and not name.startswith("_")}
    assert stubs.keys() == functions.keys()
    for name, node in stubs.items():
        stated = [a.arg for a in node.args.args] + [a.arg for a in node.args.kwonlyargs]
        defaults = [ast.literal_eval(each) for each in node.args.kw_defaults]
        parameters = inspect.signature(functions[name]).parameters.values()
        assert stated == [p.name for p in parameters], name
        assert defaults == [p.default for p in parameters if p.kind is p.KEYWORD_ONLY], name
        assert all(p.name in functions[name].__doc__ or p.name == "captures" for p in parameters), name


def test_the_public_names_are_listed():
    """Proves that __all__ holds every public class and function."""
    public = {name for name, each in vars(naocal).items()
              if not name.startswith("_") and (inspect.isclass(each) or inspect.isfunction(each))}
    assert public == set(naocal.__all__)
