package mien;

/** What was learned of faces and expressions. Immutable: share freely between threads. */
public final class ExpressionModel extends NativeObject {
    ExpressionModel(long handle) { super(Native.EXPRESSION_MODEL, handle); }
}
