// The glossary's Markdown, as text (esbuild's loader "text").
declare module "*.md" {
  const text: string;
  export default text;
}
